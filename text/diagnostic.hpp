#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

enum class Severity { error, warning };

/// A second place in a text that a diagnostic shows, such as the earlier of two equal declarations.
struct SecondPlace {
    std::string message;
    Location location;
};

/// A fault in a text that a user wrote: what is wrong, where, what would be right, and other places to look at.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string message;
    Location location;
    std::string hint = "";                ///< what would be right; "" if this is not known
    std::vector<SecondPlace> others = {}; ///< usually at most one place
};

/// These functions make an error or a warning with a line and a column, but without a file. They are for readers that
/// do not know the name of the file.
Diagnostic error_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");
Diagnostic warning_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");

/// Returns whether one of the diagnostics is an error, so that the text cannot be used.
bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// Formats a diagnostic as compilers do: `path:line:column: error: message`, the source line, a caret under the column,
/// `hint: ...`, and the second places as notes. The result ends with a newline. Control characters are shown as escapes
/// such as `\x1b`, except tabs. If the source line is long, only the part around the caret is shown.
std::string render(const Diagnostic& diagnostic);
std::string render(const SecondPlace& other); ///< returns only the note
std::string render(const std::vector<Diagnostic>& diagnostics);

/// Returns a line such as `... 3 more errors not shown`; "" if the count is 0.
std::string not_shown(std::size_t count, Severity severity);

} // namespace placedpar
