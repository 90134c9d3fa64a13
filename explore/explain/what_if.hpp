#pragma once

#include "explore/explain/changes.hpp"
#include "explore/netlist_run.hpp"
#include "observe/critical_path/critical_path.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// Reads the netlist with these settings. Throws UserError when it is refused. May be called by several threads at
/// once.
using ChangedNetlist = std::function<Network(const Overrides&)>;

/// What a change makes of the run.
struct Answer {
    Change change;
    Ending ending = Ending::interrupted;
    Time time{};
    std::string refused = ""; ///< first line of the refusal; "" if the netlist was accepted
    std::string why = "";     ///< it takes longer: what its critical path has more of

    bool completed() const { return refused.empty() && ending == Ending::completed; }
};

/// How the changed netlists are run.
struct WhatIfs {
    ChangedNetlist read;
    std::uint64_t seed;
    Time until;
    const Interruption& interruption;                       ///< changes not tried when it comes are left out
    std::function<void(std::size_t, std::size_t)> progress; ///< changes done, all changes
};

/// The changed runs, in parallel on all cores; the shortest first, then those that do not complete, then those that
/// the netlist refuses. The path is the unchanged run's.
std::vector<Answer> try_out(const std::vector<Change>&, const std::vector<PathPart>& path, const WhatIfs&);

} // namespace placedpar
