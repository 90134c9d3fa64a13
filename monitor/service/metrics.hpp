#pragma once

#include "monitor/memory/diagnoses.hpp"
#include "monitor/memory/entries.hpp"
#include "monitor/protocol/answers.hpp"

#include <string>
#include <vector>

namespace placedpar::monitor {

/// What can be seen of the service from outside.
struct ServiceSnapshot {
    const Diagnoses* diagnoses;
    Load load;
    std::vector<KeptAlarm> alarms; ///< that hold
    bool kept;                     ///< would a restart know everything?
    std::string trouble;           ///< why not
};

/// In Prometheus' text form, version 0.0.4.
std::string metrics_text(const ServiceSnapshot& snapshot);
/// For the page: the load, the machines with their newest estimates, the alarms that hold.
std::string snapshot_json(const ServiceSnapshot& snapshot);
/// For the page: what the state file has of a machine, the newest first.
std::string history_json(const std::vector<KeptEstimate>& estimates, const std::vector<KeptAlarm>& alarms);

} // namespace placedpar::monitor
