#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

enum class Severity { error, warning };

/// Another place that a diagnostic names, such as the earlier of two equal declarations.
struct SecondPlace {
    std::string message;
    Location location;
};

/// A fault in a text: what is wrong, where, what would be right, and other places that it involves.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string message;
    Location location;
    std::string hint = "";                ///< advice on what would be right; "" if there is none
    std::vector<SecondPlace> others = {}; ///< usually at most one place
};

/// These functions make an error or a warning about a text whose name only the caller knows.
Diagnostic error_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");
Diagnostic warning_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");

/// Returns whether one of the diagnostics is an error. If so, the text cannot be used.
bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// Formats the diagnostic as compilers do: `path:line:column: error: message`, the source line, a caret under the
/// column, then `hint: ...`, and the second places as notes. The result ends with a newline. Tabs are kept, also in the
/// caret's line; other control characters are shown as escapes such as `\x1b`. A long line is cut to the part around
/// the caret.
std::string render(const Diagnostic& diagnostic);
std::string render(const SecondPlace& other); ///< the note alone
std::string render(const std::vector<Diagnostic>& diagnostics);

/// Returns `... 3 more errors not shown`, with a newline; "" if the count is 0.
std::string not_shown(std::size_t count, Severity severity);

} // namespace placedpar
