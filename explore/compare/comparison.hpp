#pragma once

#include "explore/compare/differences.hpp"
#include "explore/netlist_run.hpp"
#include "netlist/read.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

/// One of the two netlists that are compared, with the settings of its run.
struct ComparedRun {
    std::string name; ///< as the user named it
    ParsedNetlist parsed;
    Overrides set = {};
    std::uint64_t seed = 1;
    Time until = Time::max();
    std::optional<std::uint64_t> shuffle = {};
};

/// Reads a run from the report that `placedpar run --json` wrote. Throws UserError if the file is not such a report. If
/// the netlist has changed since the report was written, calls `warn` with a sentence about it.
ComparedRun run_of_report(const std::string& path, const std::function<void(const std::string&)>& warn);

/// Reads the network of a run. Throws RefusedInput.
Network load_compared(const ComparedRun&);

/// A run of network A with one change: A was made equal to B in one of the differences.
struct OneChange {
    std::string what;   ///< "clock of t[0]: 20000000 in A, 10000000 in B"
    Overrides set = {}; ///< settings of the netlist that make the change; empty if the change is in the structure or in
                        ///< the settings of the run
    RunOutcome outcome = RunOutcome::interrupted;
    Time time{};
    std::string refused = ""; ///< first line of the refusal; "" if the netlist was accepted

    bool completed() const { return refused.empty() && outcome == RunOutcome::completed; }
};

struct NetlistComparison {
    std::string name_a, name_b;
    Network a, b;
    RunReport report_a, report_b;
    std::vector<SettingDifference> settings; ///< constants (`val`) that differ, and other settings that differ for
                                             ///< another reason than the constants
    std::vector<StructureDifference> structure;
    /// Sections of the netlists that differ only because the constants differ.
    std::set<StructureDifference::Section> following;
    std::vector<OneChange> alone;      ///< runs of A, each with one difference removed
    std::optional<OneChange> together; ///< A with all settings of B; empty if fewer than two settings differ

    bool both_completed() const;
    Time difference() const { return report_b.result.time - report_a.result.time; }
};

/// Compares two netlists and their runs, to find out which difference makes one run faster. If both runs complete,
/// applies each difference separately to A, and runs the changed A. Throws RefusedInput if A or B is refused.
/// `progress` is called with the number of ended runs and the number of all runs.
NetlistComparison compare_runs(const ComparedRun& a, const ComparedRun& b, const Interruption&,
                               const std::function<void(std::size_t, std::size_t)>& progress);

/// Returns the comparison as text for readers.
std::string print_compared(const NetlistComparison&);

} // namespace placedpar
