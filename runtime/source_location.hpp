#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar {

/// A place in the program. Reports use it to name the statement at which a process waits. std::source_location cannot
/// be used, because Clang before version 15 cannot compile it.
struct SourceLocation {
    const char* file = "";  ///< as passed to the compiler
    std::uint32_t line = 0; ///< 0 if no place is known

    /// Returns the place of the call. As a function's default argument, returns the place where that function is
    /// called.
    static constexpr SourceLocation current(const char* file = __builtin_FILE(),
                                            std::uint32_t line = __builtin_LINE()) {
        return {file, line};
    }
};

/// Returns a text such as "slave.cpp:57"; empty if no place is known.
inline std::string text_of(const SourceLocation& where) {
    std::string_view file = where.file;
    file.remove_prefix(file.find_last_of('/') + 1);
    return where.line == 0 ? "" : std::string(file) + ":" + std::to_string(where.line);
}

} // namespace placedpar
