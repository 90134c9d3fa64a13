#pragma once

#include <string>

namespace placedpar {

/// For a handler of all exceptions around code that a program adds to the house's: what() of the exception, the text
/// that was thrown, or that it is neither. What ends a process, Unwinding and ReplayDivergence, is thrown on.
std::string what_was_thrown();

} // namespace placedpar
