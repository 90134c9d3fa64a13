#pragma once

#include "explore/explain/explanation.hpp"
#include "explore/workers.hpp"
#include "netlist/network/network.hpp"
#include "netlist/read.hpp"

#include <cstddef>
#include <functional>

namespace placedpar {

/// Returns the explanation of a run's time, without answers to "what if a part were faster?". REQUIRES: the critical
/// path has observed the run.
Explanation explanation_of(RunReport, const CriticalPath&);

/// The data for repeating a run with changes of its netlist.
struct ChangedRuns {
    ParsedNetlist parsed;
    Overrides set; ///< settings of the user; a change may replace them
    std::uint64_t seed;
    Time until;
    /// Called with the number of changes tried and the number of all changes.
    std::function<void(std::size_t, std::size_t)> progress;
    HostServices host = {};              ///< services of the host in the changed runs
    std::size_t at_once = count_cores(); ///< number of runs at a time
};
/// Runs the netlist with changes such as a faster link, and adds the resulting times to the explanation. If changes
/// cannot be compared, says why in Explanation::not_tried.
void add_answers(Explanation&, const Network&, const ChangedRuns&, const Interruption&);

} // namespace placedpar
