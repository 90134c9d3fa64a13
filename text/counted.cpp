#include "text/counted.hpp"

#include <fmt/format.h>

namespace placedpar {

std::string counted(std::size_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}{}", count, count == 1 || more.empty() ? one : more,
                       count == 1 || !more.empty() ? "" : "s");
}

std::string with_article(std::string_view noun) {
    bool vowel = !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
    return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

} // namespace placedpar
