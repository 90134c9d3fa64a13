#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// A place in the program, by which reports name the statement that waits. It is not std::source_location, which Clang
/// before version 15 cannot compile: a program may be compiled by another compiler than the rooms that it links.
struct SourceLocation {
    const char* file = "";  ///< as passed to the compiler
    std::uint32_t line = 0; ///< 0 if no place is known

    /// Returns the place of the call; as a default argument of a function, the place where that function is called.
    static constexpr SourceLocation current(const char* file = __builtin_FILE(),
                                            std::uint32_t line = __builtin_LINE()) {
        return {file, line};
    }
};

/// "slave.cpp:57"; empty for no place.
inline std::string text_of(const SourceLocation& where) {
    std::string_view file = where.file;
    file.remove_prefix(file.find_last_of('/') + 1);
    return where.line == 0 ? "" : std::string(file) + ":" + std::to_string(where.line);
}

} // namespace placedpar
