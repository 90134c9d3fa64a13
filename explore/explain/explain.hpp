#pragma once

#include "explore/explain/explanation.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/read.hpp"

namespace placedpar {

/// A netlist whose changes are tried.
struct NetlistToChange {
    ParsedNetlist parsed;
    Overrides set; ///< settings that a change may replace
};

/// Returns the explanation of a run that `path` has observed, without answers.
Explanation explanation_of(RunReport, const CriticalPath& path);

/// Tries out the changes that are worth trying, and adds the answers; or the reason why there are none. `network` is
/// the network that was run, `progress` as WhatIfs::progress. Interrupted runs are left out.
void add_answers(Explanation&, const Network& network, const NetlistToChange&, std::uint64_t seed, Time until,
                 const Interruption&, const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace placedpar
