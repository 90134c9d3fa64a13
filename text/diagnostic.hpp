#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

enum class Severity { error, warning };

/// A second place that a diagnostic is about, such as the first of two declarations.
struct SecondPlace {
    std::string message;
    Location location;
};

/// One thing that is wrong with a text: what, where, what would be right, and the other places it has to do with.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string message;
    Location location;
    std::string hint = "";                ///< what would be right; "" if there is nothing to say
    std::vector<SecondPlace> others = {}; ///< mostly none or one
};

/// A diagnostic of a text whose name only the caller knows.
Diagnostic error_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");
Diagnostic warning_at(std::size_t line, std::size_t column, std::string message, std::string hint = "");

/// Returns whether a diagnostic is an error: then the text cannot be used.
bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// As compilers print it: `path:line:column: error: message`, the source line, a caret under the column,
/// then `hint: ...` and the second places as notes. Ends with a newline. Tabs are shown as they are and the
/// caret's line repeats them; other control characters are shown as `\x1b`; a long line is shown around the caret.
std::string render(const Diagnostic& diagnostic);
std::string render(const SecondPlace& other); ///< the note alone
std::string render(const std::vector<Diagnostic>& diagnostics);

/// `... 3 further errors not shown`, with a newline; "" for none.
std::string not_shown(std::size_t count, Severity severity);

} // namespace placedpar
