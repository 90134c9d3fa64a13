#pragma once

#include "serve/confinement.hpp"

#include <string>

namespace placedpar::serve {

/// Executes one job and returns its answer. Both are JSON. A job has these members:
///
///   "do"        "check", "run", "explain", "listing" or "exercise"
///   "main"      the file that is checked or run: a netlist or a configuration, or a program in occam (.occ)
///   "files"     {name: text}; no other file is read
///   "seed"      the seed of the run; 1 if it is missing
///   "exercise"  the number of the exercise that "main" solves
///   "expected"  what a solution prints, if the task is not an exercise of the course
///   "keys"      the keys that are pressed for a program; none if it is missing
///
/// The answer to "check" is {"faults": [...]}. The other answers have "ended" and "warnings". If there is no run, they
/// have "faults" and "refused", which says why as the command line does. After a run they have "output" (the text that
/// booted programs printed), "report" and "page" (HTML), and, if requested, "explanation" or "listing". After an
/// exercise, they have "verdict", "result" (name_of(StudentRun::End)) and, if the program ran to its end,
/// "simulated_ms".
///
/// "ended" is the ending of the run as name_of(Ending) writes it, "solved" or "not solved" after an exercise, "refused"
/// if there is no run, or "failed" after a failure. A process that is killed at a limit has no answer; the service
/// answers with "killed" (serve/runs.hpp).
///
/// After `limits.seconds` the run is interrupted, and the answer has the results up to then.
std::string answer_of(const std::string& job, const RunLimits& limits);

/// Reads a job from standard input, confines this process, and writes the answer to standard output.
void do_job(const RunLimits& limits);

} // namespace placedpar::serve
