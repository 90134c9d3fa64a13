#include "hydraulics/data/link.hpp"

#include <algorithm>

namespace placedpar::hydraulics {

namespace {

constexpr std::array<std::string_view, 4> names{"bucket", "boom", "stick", "swing"};
constexpr std::array<std::string_view, 4> symbols{"BU", "BO", "ST", "SW"};

} // namespace

std::string_view name_of(Link link) { return names[index_of(link)]; }

std::string_view symbol_of(Link link) { return symbols[index_of(link)]; }

std::optional<Link> link_named(std::string_view text) {
    auto found =
        std::ranges::find_if(all_links, [&](Link link) { return text == name_of(link) || text == symbol_of(link); });
    return found == all_links.end() ? std::nullopt : std::optional(*found);
}

} // namespace placedpar::hydraulics
