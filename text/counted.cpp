#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

std::string counted(std::size_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}{}", count, count == 1 || more.empty() ? one : more,
                       count == 1 || !more.empty() ? "" : "s");
}

std::string with_unit(double value, std::string_view unit) {
    auto is_letter = [](char each) { return each >= 'a' && each <= 'z'; };
    bool is_plural = unit.size() >= 4 && unit.back() == 's' && std::ranges::all_of(unit, is_letter);
    if (is_plural && value == 1)
        unit.remove_suffix(1);
    return fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string with_article(std::string_view noun) {
    bool vowel = !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
    return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

} // namespace placedpar
