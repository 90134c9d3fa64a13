#pragma once

#include "explore/netlist_run.hpp"
#include "serve/runs.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::serve {

/// A task that many students have solved. Either `exercise` or `expected` is given.
struct MarkedTask {
    std::string exercise;                ///< a number of the course: "3.2"
    std::optional<std::string> expected; ///< what a solution prints
};

/// What was found out about a submission.
struct Mark {
    std::string file; ///< path below the folder of submissions
    /// "solved", "wrong output", "deadlock", "too long" (simulated), "too much output", "failed", "refused" (with
    /// errors), "out of time" (of this computer), "killed" (at a limit), or "nothing submitted".
    std::string result;
    std::optional<double> simulated_ms; ///< of the run in the usual order; empty: the program did not run to its end
    std::string why;                    ///< some lines; "" if it is solved
};

/// Returns the programs in occam (.occ) in the folder and its subfolders, as paths below the folder, sorted. Throws
/// UserError if there is none, or if the folder cannot be read.
std::vector<std::filesystem::path> submissions_in(const std::filesystem::path& folder);

/// Returns the names of the folders in the folder that have no submission inside, sorted.
std::vector<std::filesystem::path> folders_without_submission(const std::filesystem::path& folder,
                                                              const std::vector<std::filesystem::path>& submissions);

/// Runs each submission as check_solution() does, in a confined process of its own within the limits. A submission may
/// include the files of its own folder that end in .inc. `progress` receives the number of marked submissions. Returns
/// the marks so far, in the order of the submissions, if the run is interrupted.
std::vector<Mark> marks_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& submissions,
                           const MarkedTask& task, const QueueLimits& limits,
                           const std::function<void(std::size_t)>& progress, const Interruption& interruption);

/// Returns the marks as comma-separated values: file, result, simulated_ms, why.
std::string marks_csv(const std::vector<Mark>& marks);

} // namespace placedpar::serve
