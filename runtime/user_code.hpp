#pragma once

#include <string>

namespace placedpar {

/// Returns the text of the current exception: what(), a thrown string, or a remark that it is neither. For handlers
/// around code that a program adds to PlacedPar. Unwinding and ReplayDivergence, which end a process, are rethrown.
std::string what_was_thrown();

} // namespace placedpar
