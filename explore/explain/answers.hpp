#pragma once

#include "explore/explain/explanation.hpp"
#include "explore/workers.hpp"
#include "netlist/network/network.hpp"
#include "netlist/read.hpp"

#include <cstddef>
#include <functional>

namespace placedpar {

/// Returns the explanation of a run that the critical path has observed; no change has been tried yet.
Explanation explanation_of(RunReport, const CriticalPath&);

/// The data for repeating a run with changes.
struct ChangedRuns {
    ParsedNetlist parsed;
    Overrides set; ///< settings of the user; a change may replace them
    std::uint64_t seed;
    Time until;
    std::function<void(std::size_t, std::size_t)> progress; ///< as WhatIfs::progress
    HostServices host = {};                                 ///< host of the changed runs
    std::size_t at_once = count_cores();                    ///< number of runs at a time
};
/// Tries the changes that are worth trying and adds the answers, or says in `not_tried` why no change can be compared.
void add_answers(Explanation&, const Network&, const ChangedRuns&, const Interruption&);

} // namespace placedpar
