#pragma once

#include "explore/exercise/course.hpp"
#include "explore/netlist_run.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace placedpar {

/// What a student's program has printed, and how its run has ended.
struct StudentRun {
    enum class End { completed, failed, deadlock, too_long, too_much_output, interrupted };

    End end = End::completed;
    std::string output = "";
    std::string state = ""; ///< of the program: "exited with failure"
    Time time{};            ///< simulated time at the end
};

/// Returns "solved", "wrong output", "deadlock" and so on; `wrong` is what what_is_wrong() returned.
const char* name_of(StudentRun::End, const std::string& wrong);

/// Runs the program of a network with one transputer and a host. No key is pressed, and no file can be used. The run
/// ends after 10 s of simulated time, or 64 Kbyte of output. `shuffle`: if set, ready processes run in an order drawn
/// from this seed.
StudentRun run_student_program(const Network&, std::optional<std::uint64_t> shuffle, Interruption&);

/// Says what is wrong with a run in some lines without a newline at the end; "" if nothing is. Blanks at the ends
/// of lines, and empty lines at the end, are ignored.
std::string what_is_wrong(const StudentRun&, const std::string& expected);

/// The verdict on a solution of an exercise.
struct SolutionVerdict {
    StudentRun::End end; ///< of the run that decided
    std::string wrong;   ///< some lines; "": solved, or interrupted
    Time time;           ///< simulated time of the run in the usual order

    /// Returns "solved; ..." or "not solved: ...". REQUIRES: not interrupted.
    std::string text() const;
};
/// Runs the program in the usual order of its processes and in other orders, until something is wrong.
SolutionVerdict check_solution(const Network&, const Exercise&, Interruption&);

} // namespace placedpar
