#include "netlist/network/network.hpp"

#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar {

std::int64_t Node::integer(std::string_view attribute) const {
    auto found = attributes.find(attribute);
    if (found == attributes.end() || !std::holds_alternative<std::int64_t>(found->second))
        throw std::logic_error(fmt::format("node {} ({}) has no integer attribute {}", name, type, attribute));
    return std::get<std::int64_t>(found->second);
}

std::size_t Network::count_wires() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(connections, [](const LinkConnection& each) { return !each.over_bus; }));
}

bool are_one_broadcast(const NetworkChannel& a, const NetworkChannel& b) {
    return a.from.process == b.from.process && base_name(a.from.port) == base_name(b.from.port) &&
           a.placement.broadcast_on == b.placement.broadcast_on;
}

bool is_on_bus(const Network& network, std::size_t node) {
    return std::ranges::find(network.attachments, node, &BusAttachment::node) != network.attachments.end();
}

std::vector<std::string> paths_of_inputs(const Network& network) {
    std::vector<std::string> paths = network.included_paths;
    for (const Node& node : network.nodes)
        if (!node.boot_file.empty())
            paths.push_back(node.boot_file);
    return paths;
}

bool has_bootable_file(const Network& network) {
    return std::ranges::any_of(network.nodes, [](const Node& node) { return !node.boot_file.empty(); });
}

bool is_set_at_run_time(const Network& network, std::size_t node) {
    LinkEnd config{node, configuration_link};
    return std::ranges::any_of(network.connections,
                               [&](const LinkConnection& each) { return each.a == config || each.b == config; });
}

std::string link_name(const std::vector<Node>& nodes, const LinkEnd& end) {
    const std::string& node = nodes[end.node].name;
    if (end.link == bus_port)
        return node + ".bus[0]";
    if (end.link == configuration_link)
        return node + ".config";
    return end.at_edge() ? node : fmt::format("{}.link[{}]", node, end.link);
}

} // namespace placedpar
