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

/// What the text begins with. Overlong forms and surrogates are no characters.
Utf8Character first_character(std::string_view text);

/// The text as a terminal may have it: control characters, and bytes that are no UTF-8, as `\x1b`. Tabs stay.
std::string escaped(std::string_view text);

} // namespace placedpar
