#pragma once

#include "monitor/memory/diagnoses.hpp"
#include "monitor/memory/entries.hpp"
#include "monitor/protocol/answers.hpp"

#include <string>
#include <vector>

namespace placedpar::monitor {

class NetlistSearches; // monitor/service/netlist_searches.hpp

/// The state of the service that its web page and Prometheus show.
struct ServiceSnapshot {
    const Diagnoses* diagnoses;
    Load load;
    std::vector<KeptAlarm> alarms;   ///< active alarms
    bool kept;                       ///< whether a restart would restore everything
    std::string trouble;             ///< if `kept` is false, the reason
    const NetlistSearches* searches; ///< may be null
};

/// Returns the snapshot in the text format of Prometheus, version 0.0.4.
std::string metrics_text(const ServiceSnapshot& snapshot);
/// Returns for the web page the load, the machines with their newest estimates, and the active alarms.
std::string snapshot_json(const ServiceSnapshot& snapshot);
/// Returns for the web page the history of a machine from the state file, newest first.
std::string history_json(const std::vector<KeptEstimate>& estimates, const std::vector<KeptAlarm>& alarms);

} // namespace placedpar::monitor
