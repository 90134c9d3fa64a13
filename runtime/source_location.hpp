#pragma once

#include <version>

#if defined(__cpp_lib_source_location)
#include <source_location>
#else
#include <experimental/source_location>
#endif

namespace placedpar {

/// A place in the program, by which reports name the statement that waits. Clang before version 15 cannot compile
/// std::source_location, but has its forerunner from the library fundamentals.
#if defined(__cpp_lib_source_location)
using SourceLocation = std::source_location;
#else
using SourceLocation = std::experimental::source_location;
#endif

} // namespace placedpar
