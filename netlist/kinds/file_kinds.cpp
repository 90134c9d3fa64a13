#include "netlist/kinds/file_kinds.hpp"

#include "netlist/kinds/device_kind.hpp"

#include <utility>

namespace placedpar {

std::optional<int> link_to_host(const Network& network, std::size_t node) {
    for (const LinkConnection& wire : network.connections)
        for (const auto& [near, far] : {std::pair(wire.a, wire.b), std::pair(wire.b, wire.a)})
            if (near.node == node && far.at_edge() && !wire.over_bus)
                return near.link;
    return std::nullopt;
}

} // namespace placedpar
