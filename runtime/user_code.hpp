#pragma once

#include <string>

namespace placedpar {

/// For a handler of all exceptions around code that a program adds to the house's: what() of the exception that is
/// being handled, or that it is not a std::exception. What ends a process, Unwinding and Departure, is thrown on.
std::string what_was_thrown();

} // namespace placedpar
