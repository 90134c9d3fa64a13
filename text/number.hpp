#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace placedpar {

/// Returns the number that the text spells, in the syntax of std::from_chars. Returns nullopt if anything else is in
/// the text, such as a blank, or if the number exceeds the type's range. "inf" and "nan" are floating-point numbers.
template <class Number, class... Base>
std::optional<Number> parse_number(std::string_view text, Base... base) {
    Number number{};
    const char* end = text.data() + text.size();
    auto [stop, error] = std::from_chars(text.data(), end, number, base...);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

} // namespace placedpar
