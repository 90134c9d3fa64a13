#pragma once

#include <string>
#include <string_view>
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

/// "slave.cpp:57"; empty for no place.
inline std::string text_of(const SourceLocation& where) {
    std::string_view file = where.file_name();
    file.remove_prefix(file.find_last_of('/') + 1);
    return where.line() == 0 ? "" : std::string(file) + ":" + std::to_string(where.line());
}

} // namespace placedpar
