#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/identification_way.hpp"

#include <optional>
#include <vector>

namespace placedpar::identification {

/// Which compliances of a record are to be identified, and how its readings are meant.
struct Question {
    hydraulics::Configuration configuration = hydraulics::Configuration::a;
    hydraulics::LinkSet links = {hydraulics::Link::boom};
    std::optional<double> spool_offset_in;                ///< of the boom; subtracted from its readings
    std::optional<hydraulics::AreasFrom> areas_from = {}; ///< none: the first source that the record has
};

/// A search for compliances, set up from a record.
struct ComplianceSearch {
    CircuitProblem problem;
    hydraulics::FlowConstants flow;
    hydraulics::LinkCalibrations calibrations;
    std::vector<hydraulics::CircuitSample> samples; ///< the usable ones
};

/// The resolution of the spool's sensor.
double spool_sensor_step_in(const hydraulics::Parameters& machine);

/// Throws UserError when the links are not of one coupled group of the configuration, and UnfitRecord when
/// the record lacks a channel.
ComplianceSearch prepare(const hydraulics::Record& record, const hydraulics::Parameters& machine,
                         const Question& question, const IdentificationWay& way);

} // namespace placedpar::identification
