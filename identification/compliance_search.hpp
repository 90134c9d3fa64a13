#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/identification_way.hpp"

#include <optional>
#include <vector>

namespace placedpar::identification {

/// What a user wants to know from a record: which compliances to identify, and how to interpret the record's readings.
struct Question {
    hydraulics::Configuration configuration = hydraulics::Configuration::a;
    hydraulics::LinkSet links = {hydraulics::Link::boom};
    std::optional<double> spool_offset_in; ///< offset that is subtracted from the readings of the boom's spool
    std::optional<hydraulics::AreasFrom> areas_from = {}; ///< nullopt: the first of areas, spool and servo that the
                                                          ///< record has
    hydraulics::Side side = hydraulics::Side::inlet;
};

/// All that a search for compliances needs, taken from a record.
struct ComplianceSearch {
    CircuitProblem problem;
    hydraulics::FlowConstants flow;
    hydraulics::LinkCalibrations calibrations;
    std::vector<hydraulics::CircuitSample> samples; ///< only the usable samples
};

/// Returns the resolution of the spool's sensor, which limits how small an offset can be found.
double spool_sensor_step_in(const hydraulics::Parameters& machine);

/// Prepares the search for the compliances that the question asks for. All links must be in one coupled group, that is,
/// share oil in this configuration (hydraulics::coupled_groups()); otherwise throws UserError. For the outlet side,
/// also throws UserError if the question has another link than the boom, or if areas_from is AreasFrom::areas. Throws
/// UnfitRecord if the record lacks a needed channel.
ComplianceSearch prepare(const hydraulics::Record& record, const hydraulics::Parameters& machine,
                         const Question& question, const IdentificationWay& way);

} // namespace placedpar::identification
