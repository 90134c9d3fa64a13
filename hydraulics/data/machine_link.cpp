#include "hydraulics/data/machine_link.hpp"

#include <algorithm>

namespace placedpar {

namespace {

constexpr std::array<std::string_view, 4> names{"bucket", "boom", "stick", "swing"};
constexpr std::array<std::string_view, 4> symbols{"BU", "BO", "ST", "SW"};

} // namespace

std::string_view name_of(MachineLink link) { return names[index_of(link)]; }

std::string_view symbol_of(MachineLink link) { return symbols[index_of(link)]; }

std::optional<MachineLink> link_named(std::string_view text) {
    auto found = std::ranges::find_if(
        all_links, [&](MachineLink link) { return text == name_of(link) || text == symbol_of(link); });
    return found == all_links.end() ? std::nullopt : std::optional(*found);
}

} // namespace placedpar
