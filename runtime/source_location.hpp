#pragma once

#include <version>

#if defined(__cpp_lib_source_location)
#include <source_location>
#else
#include <experimental/source_location>
#endif

namespace placedpar {

/// Where in the program something was asked for. Clang before version 15 lacks what std::source_location is
/// made of, and has the one of the library fundamentals, which does the same.
#if defined(__cpp_lib_source_location)
using SourceLocation = std::source_location;
#else
using SourceLocation = std::experimental::source_location;
#endif

} // namespace placedpar
