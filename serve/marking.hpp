#pragma once

#include "explore/netlist_run.hpp"
#include "serve/runs.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::serve {

/// A task whose solutions by many students are marked. Either `exercise` or `expected` is given.
struct MarkedTask {
    std::string exercise;                ///< number of an exercise of the course, such as "3.2"
    std::optional<std::string> expected; ///< output of a correct solution
};

/// The result of one student's program, a submission.
struct Mark {
    std::string file; ///< path below the folder of submissions
    /// "solved", "wrong output", "deadlock", "too long" (simulated), "too much output", "failed", "refused" (with
    /// errors), "out of time" (of this computer), "killed" (at a limit), or "nothing submitted".
    std::string result;
    std::optional<double> simulated_ms; ///< simulated time of the run without shuffling of ready processes; nullopt if
                                        ///< the program did not run to its end
    std::string why;                    ///< explanation of a few lines; "" if the task is solved
};

/// Returns the programs in occam (.occ) in the folder and its subfolders, as paths below the folder, sorted. Throws
/// UserError if the folder has no such program, or cannot be read.
std::vector<std::filesystem::path> submissions_in(const std::filesystem::path& folder);

/// Returns the names of the subfolders of `folder` that contain no submission, sorted. These students have submitted
/// nothing.
std::vector<std::filesystem::path> folders_without_submission(const std::filesystem::path& folder,
                                                              const std::vector<std::filesystem::path>& submissions);

/// Runs each submission and compares its output with a correct solution's, as check_solution() does. Each runs in a
/// confined process of its own within the limits. A submission may include the files of its own folder that end in
/// .inc. `progress` receives the number of marked submissions. Returns the marks in the order of the submissions. After
/// an interruption, returns only the marks so far.
std::vector<Mark> marks_of(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& submissions,
                           const MarkedTask& task, const QueueLimits& limits,
                           const std::function<void(std::size_t)>& progress, const Interruption& interruption);

/// Returns the marks as comma-separated values: file, result, simulated_ms, why.
std::string marks_csv(const std::vector<Mark>& marks);

} // namespace placedpar::serve
