#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// A character of a text, and its number of bytes.
struct Utf8Character {
    char32_t code = 0;
    std::size_t bytes = 0; ///< 0: the text does not begin with a valid character
};

/// Returns the first character of the text. Overlong forms and surrogates are not valid.
Utf8Character first_character(std::string_view text);

/// Returns the text in valid UTF-8. A byte that is not part of a UTF-8 character is taken as a Latin-1 character, as in
/// old files.
std::string as_utf8(std::string_view text);

/// Returns the text in a form for XML and HTML, as content of an element or as value of an attribute. Converts it to
/// valid UTF-8 by as_utf8(), and escapes `<`, `>`, `&` and `"`. Control characters, which XML forbids, become `?`.
std::string as_markup(std::string_view text);

/// Returns a JSON text in a form that is safe for other programs and for terminals. Converts it to valid UTF-8 by
/// as_utf8(), and escapes the control characters that JSON allows, for example as `\u009b`. REQUIRES: all other control
/// characters are already escaped.
std::string as_json(std::string_view json);

/// Returns the text in a form that is safe for a terminal. Control characters except tabs, and bytes that are not
/// UTF-8, become escapes such as `\x1b`.
std::string escaped(std::string_view text);

} // namespace placedpar
