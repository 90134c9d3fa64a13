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
    return std::ranges::any_of(network.nodes, [](const Node& node) { return !node.boot_file.empty() || node.image; });
}

namespace {

/// Returns the new index of each element of `things` after all elements for which `stays` returns false are removed;
/// nowhere for a removed element.
template <class Things, class Stays>
std::vector<std::size_t> positions_after(const Things& things, const Stays& stays) {
    std::vector<std::size_t> positions;
    std::size_t next = 0;
    for (const auto& each : things)
        positions.push_back(stays(each) ? next++ : nowhere);
    return positions;
}

} // namespace

Network with_code_inside(Network network) {
    const auto stays = [](const ProcessInstance& process) { return !process.is_code; };
    const std::vector<std::size_t> processes = positions_after(network.processes, stays);
    for (NetworkChannel& channel : network.channels)
        for (ChannelEnd* const end : {&channel.from, &channel.to})
            if (!end->at_edge() && (end->process = processes[end->process]) == nowhere)
                end->port.clear();
    const auto is_outside = [](const NetworkChannel& channel) {
        return !channel.from.at_edge() || !channel.to.at_edge();
    };
    const std::vector<std::size_t> channels = positions_after(network.channels, is_outside);
    std::erase_if(network.channels, [&](const NetworkChannel& channel) { return !is_outside(channel); });
    std::erase_if(network.processes, [&](const ProcessInstance& process) { return !stays(process); });
    for (ProcessInstance& process : network.processes)
        for (PortBinding& port : process.ports)
            port.channel = channels[port.channel];
    return network;
}

bool is_between_code(const Network& network, const NetworkChannel& channel) {
    const auto is_code = [&](const ChannelEnd& end) {
        return !end.at_edge() && network.processes[end.process].is_code;
    };
    return is_code(channel.from) && is_code(channel.to);
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
