#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// A character of a text, and its number of bytes.
struct Utf8Character {
    char32_t code = 0;
    std::size_t bytes = 0; ///< 0: the text does not begin with a character
};

/// Returns the first character of the text. Overlong forms and surrogates are not characters.
Utf8Character first_character(std::string_view text);

/// Returns the text in UTF-8. A byte that is not part of a UTF-8 character is read as Latin-1, which old files use.
std::string as_utf8(std::string_view text);

/// Returns the text for an element or an attribute's value in XML or HTML: escapes `<`, `>`, `&` and `"`, treats bytes
/// as as_utf8() does, and shows control characters, which XML forbids, as `?`.
std::string as_markup(std::string_view text);

/// Returns the JSON text in a form that is safe for other programs and for terminals: treats bytes as as_utf8() does,
/// and escapes the control characters that JSON allows, for example as `\u009b`. REQUIRES: all other control characters
/// are already escaped.
std::string as_json(std::string_view json);

/// Returns the text in a form that is safe for a terminal: control characters, and bytes that are not UTF-8, are
/// written as escapes such as `\x1b`. Tabs stay.
std::string escaped(std::string_view text);

} // namespace placedpar
