#pragma once

#include "serve/confinement.hpp"

#include <string>

namespace placedpar::serve {

/// Returns the answer to a job, a run that a user of the web page starts (serve/answer.hpp). After `limits.seconds` the
/// run is interrupted, and the answer has the results so far.
std::string answer_of(const std::string& job, const RunLimits& limits);

/// Reads a job from standard input, confines this process (serve/confinement.hpp), and writes the answer to standard
/// output. The service starts a process with this function for each job. Returns whether the input was a job.
bool do_job(const RunLimits& limits);

} // namespace placedpar::serve
