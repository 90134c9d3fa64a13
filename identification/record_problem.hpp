#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

#include <optional>

namespace placedpar {

/// What of a record is to be identified.
struct Question {
    hydraulics::Configuration configuration = hydraulics::Configuration::a;
    hydraulics::LinkSet links = {hydraulics::Link::boom};
    std::optional<double> spool_offset_in;                ///< of the boom; taken off its readings
    std::optional<hydraulics::AreasFrom> areas_from = {}; ///< none: the first that the record has
};

/// A record made ready for identification.
struct RecordProblem {
    hydraulics::CircuitProblem problem;
    hydraulics::FlowConstants flow;
    hydraulics::LinkCalibrations calibrations;
    std::vector<hydraulics::CircuitSample> samples; ///< the usable ones
};

/// The least difference of spool that the machine's sensor tells.
double spool_sensor_step_in(const hydraulics::Parameters& machine);

/// Throws std::invalid_argument: the links are not of one coupled group of the configuration; or UnfitRecord, which
/// lacks a channel.
RecordProblem prepare(const hydraulics::Record& record, const hydraulics::Parameters& machine, const Question& question,
                      const IdentificationWay& way);

} // namespace placedpar
