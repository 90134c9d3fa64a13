#pragma once

#include <string>

namespace placedpar {

/// Returns a text for the current exception: its what(), a thrown string, or a remark that the exception has no text.
/// Call this function in a handler around code of the user. Rethrows the exceptions by which the simulation itself ends
/// a process (Unwinding and ReplayDivergence).
std::string what_was_thrown();

} // namespace placedpar
