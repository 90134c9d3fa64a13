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

/// The run with a change, beside the unchanged one.
struct Answer {
    Change change;
    Ending ending = Ending::interrupted;
    Time time{};
    std::string refused = ""; ///< first line of the refusal; "" if the netlist was accepted
    std::string why = "";     ///< if the run takes longer: what takes more time on its critical path

    bool completed() const { return refused.empty() && ending == Ending::completed; }
};

/// The settings of the changed runs.
struct WhatIfs {
    ChangedNetlist read;
    std::uint64_t seed;
    Time until;
    const Interruption& interruption;                       ///< changes not tried when it comes are left out
    std::function<void(std::size_t, std::size_t)> progress; ///< changes done, all changes
};

/// Makes the changed runs in parallel on all cores. Returns the shortest first, then those that do not complete, then
/// those with which the netlist is refused. `path`: the critical path of the unchanged run.
std::vector<Answer> try_out(const std::vector<Change>&, const std::vector<PathPart>& path, const WhatIfs&);

} // namespace placedpar
