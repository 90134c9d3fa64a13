#pragma once

#include "explore/exercise/course.hpp"
#include "explore/netlist_run.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace placedpar {

/// The output of a student's program, and the end of its run.
struct StudentRun {
    enum class End { completed, failed, deadlock, too_long, too_much_output, interrupted };

    End end = End::completed;
    std::string output = "";
    std::string state = ""; ///< state of the program, such as "exited with failure"
    Time time{};            ///< simulated time at the end
};

/// Returns "solved", "wrong output", "deadlock" and so on. `wrong` is the result of what_is_wrong().
const char* name_of(StudentRun::End, const std::string& wrong);

/// Runs the program of a network with one transputer and a host. The program gets no key and no file from the host. The
/// run ends after 10 s of simulated time, or 64 Kbyte of output. If `shuffle` is set, ready processes run in a random
/// order, and `shuffle` is the seed of this order.
StudentRun run_student_program(const Network&, std::optional<std::uint64_t> shuffle, Interruption&);

/// Describes what is wrong with a run, in a few lines without a newline at the end; returns "" if nothing is wrong.
/// Ignores blanks at the ends of lines, and empty lines at the end.
std::string what_is_wrong(const StudentRun&, const std::string& expected);

/// The verdict on a solution of an exercise.
struct SolutionVerdict {
    StudentRun::End end; ///< end of the run that decided the verdict
    std::string wrong;   ///< a few lines; "" if solved or interrupted
    Time time;           ///< simulated time of the run in the usual order

    /// Returns "solved; ..." or "not solved: ...". REQUIRES: not interrupted.
    std::string text() const;
};
/// Runs the program in the usual order of its processes, then in random orders, in which races and deadlocks may show.
/// Stops at the first wrong run.
SolutionVerdict check_solution(const Network&, const Exercise&, Interruption&);

} // namespace placedpar
