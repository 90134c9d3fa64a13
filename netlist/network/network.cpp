#include "netlist/network/network.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

std::int64_t Node::integer(std::string_view attribute) const {
    auto found = attributes.find(attribute);
    if (found == attributes.end() || !std::holds_alternative<std::int64_t>(found->second))
        throw std::logic_error(fmt::format("node {} ({}) has no integer attribute {}", name, type, attribute));
    return std::get<std::int64_t>(found->second);
}

std::string link_name(const std::vector<Node>& nodes, const LinkEnd& end) {
    const std::string& node = nodes[end.node].name;
    return end.at_edge() ? node : fmt::format("{}.link[{}]", node, end.link);
}

} // namespace placedpar
