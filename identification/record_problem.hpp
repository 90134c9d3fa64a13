#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

#include <optional>

namespace placedpar {

/// What of a record is to be identified.
struct Question {
    Configuration configuration = Configuration::a;
    LinkSet links = {MachineLink::boom};
    std::optional<double> spool_offset_in;    ///< of the boom; taken off its readings
    std::optional<AreasFrom> areas_from = {}; ///< none: the first that the record has
};

/// A record made ready for identification.
struct RecordProblem {
    CircuitProblem problem;
    FlowConstants flow;
    LinkReadings readings;
    std::vector<CircuitSample> samples; ///< the usable ones
};

/// What the readings of every link mean on a machine.
LinkReadings link_readings(const Parameters& machine);

/// The least difference of spool that the machine's sensor tells.
double spool_sensor_step_in(const Parameters& machine);

/// Throws std::invalid_argument: the links are not of one coupled group of the configuration; or UnfitRecord, which
/// lacks a channel.
RecordProblem prepare(const Record& record, const Parameters& machine, const Question& question,
                      const IdentificationWay& way);

} // namespace placedpar
