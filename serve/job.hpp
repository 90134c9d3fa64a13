#pragma once

#include "serve/confinement.hpp"

#include <string>

namespace placedpar::serve {

/// Returns the answer to a job (serve/answer.hpp). After `limits.seconds` the run is interrupted, and the answer has
/// the results up to then.
std::string answer_of(const std::string& job, const RunLimits& limits);

/// Reads a job from standard input, confines this process, and writes the answer to standard output. Returns whether
/// the input was a job.
bool do_job(const RunLimits& limits);

} // namespace placedpar::serve
