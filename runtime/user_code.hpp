#pragma once

#include <string>

namespace placedpar {

/// Returns the text of the current exception: what(), a thrown string, or a remark that the exception is neither. Call
/// it in a handler around user-defined code. Rethrows Unwinding and ReplayDivergence, which end a process.
std::string what_was_thrown();

} // namespace placedpar
