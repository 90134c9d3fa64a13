#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

enum class Severity { error, warning };

/// A second place of a diagnostic, such as the first of two declarations.
struct SecondPlace {
    std::string message;
    Location location;
};

/// A fault in a text: what is wrong, where, what would be right, and other places that it involves.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string message;
    Location location;
    std::string hint = "";                ///< what would be right; "" if there is nothing to say
    std::vector<SecondPlace> others = {}; ///< usually none or one
};

/// Makes an error in a text whose name only the caller knows.
Diagnostic error_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");
Diagnostic warning_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");

/// Returns whether a diagnostic is an error: then the text cannot be used.
bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// Formats the diagnostic as compilers do: `path:line:column: error: message`, the source line, a caret under the
/// column, then `hint: ...`, and the second places as notes. It ends with a newline. Tabs are kept, also in the caret's
/// line; other control characters are shown as `\x1b`; of a long line only the part around the caret is shown.
std::string render(const Diagnostic& diagnostic);
std::string render(const SecondPlace& other); ///< the note alone
std::string render(const std::vector<Diagnostic>& diagnostics);

/// Returns `... 3 further errors not shown`, with a newline; "" for none.
std::string not_shown(std::size_t count, Severity severity);

} // namespace placedpar
