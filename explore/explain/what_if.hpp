#pragma once

#include "explore/explain/changes.hpp"
#include "explore/netlist_run.hpp"
#include "observe/critical_path/critical_path.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A function that reads the netlist with these settings. Throws UserError if the netlist is refused. Several threads
/// may call it at the same time.
using ChangedNetlist = std::function<Network(const Overrides&)>;

struct Answer {
    Change change;
    RunOutcome outcome = RunOutcome::interrupted;
    Time time{};
    std::string refused = ""; ///< first line of the refusal; "" if the netlist was accepted
    /// If the changed run takes at least 0.1 % longer than the unchanged run, the activity whose time on the critical
    /// path grew most. Otherwise, or if the changed path is too long to be recorded, "".
    std::string why = "";

    bool completed() const { return refused.empty() && outcome == RunOutcome::completed; }
};

/// Returns whether the run did not complete, or took at least 0.1 % more or less time than the unchanged run.
bool differs(const Answer&, Time unchanged);

struct WhatIfs {
    ChangedNetlist read;
    std::uint64_t seed;
    Time until;
    const Interruption& interruption; ///< changes not yet tried at the interruption are left out
    /// Called with the number of changes tried and the number of all changes.
    std::function<void(std::size_t, std::size_t)> progress;
    std::size_t at_once; ///< number of runs at a time
};

/// Runs the netlist with each change. Returns the shortest completed runs first, then runs that did not complete, then
/// changes with which the netlist is refused. `path` is the critical path of the unchanged run.
std::vector<Answer> try_out(const std::vector<Change>&, const std::vector<PathPart>& path, const WhatIfs&);

} // namespace placedpar
