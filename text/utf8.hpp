#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

/// A character of a text, and the bytes that it takes.
struct Utf8Character {
    char32_t code = 0;
    std::size_t bytes = 0; ///< 0: the text begins with none
};

/// Returns the first character of the text. Overlong forms and surrogates are not characters.
Utf8Character first_character(std::string_view text);

/// The text with every byte that is not part of a UTF-8 character taken as Latin-1, as old files have it.
std::string as_utf8(std::string_view text);

/// The text of an element, or the value of an attribute, of XML or HTML: `<`, `>`, `&` and `"` written as these want
/// them, and bytes as in as_utf8(). Control characters, which they do not have, are shown as `?`.
std::string as_markup(std::string_view text);

/// A text of JSON as others may read it, and terminals show it: bytes as in as_utf8(), and the control characters that
/// JSON lets pass written as `\u009b`. REQUIRES: the others are written so already.
std::string as_json(std::string_view json);

/// The text as a terminal may have it: control characters, and bytes that are not UTF-8, as `\x1b`. Tabs stay.
std::string escaped(std::string_view text);

} // namespace placedpar
