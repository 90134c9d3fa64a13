#pragma once

#include <cstdint>
#include <string>

namespace placedpar {

class Interruption; // explore/netlist_run.hpp

} // namespace placedpar

namespace placedpar::serve {

/// Executes one job of the web page on which users run netlists and programs, and returns the answer. Job and answer
/// are JSON. A job has these members, of which "do", "main" and "files" are required:
///
///   "do"        "check", "run", "explain", "listing" or "exercise"
///   "main"      the file that is checked or run: a netlist or a configuration, or a program in occam (.occ)
///   "files"     {name: text}; no other file is read. A name must not begin with "/" or contain ".."
///   "seed"      the seed of the run; 1 if this member is missing
///   "exercise"  the number of the exercise that "main" solves
///   "expected"  the output of a correct solution, if the task is not an exercise of the course
///   "keys"      the keys that the program receives; none if this member is missing
///
/// The answer to "check" has only "faults". Any other answer has "ended" and, by the value of "ended", these members:
///
///   "refused"           "refused" (the reason, as the command line prints it), and "faults" unless the text was no
///                       job; there was no run
///   "failed"            "refused" (the reason); the run ended by an exception
///   a RunOutcome        "output" (text that booted programs printed), "report", "page" (HTML) or "page_missing" (the
///                       reason), and, if the job asks for it, "explanation" or "listing"
///   "solved", "not solved", "interrupted", for an exercise
///                       "verdict", "result" (name_of(StudentRun::End)), and "simulated_ms" if the program ran to its
///                       end
///
/// An answer also has "warnings", unless the run failed. A process that is killed at a limit of time or memory gives no
/// answer. The service then answers with "killed" (serve/runs.hpp).
///
/// If the interruption is requested, the run ends, and the answer has the results so far. `megabytes` is the process's
/// limit of memory. If the run exceeds it, the answer's message states this number.
std::string answer_of(const std::string& job, std::uint64_t megabytes, Interruption&);

} // namespace placedpar::serve
