#include "netlist/complete/complete.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar {

namespace {

/// Gives the host's link the speed of the link that it is connected to.
void take_speed(Node& host, const Node& neighbour) {
    if (auto speed = neighbour.attributes.find("linkspeed"); speed != neighbour.attributes.end())
        host.attributes.insert_or_assign("linkspeed", speed->second);
}

/// Turns the node `host`, an edge of the netlist, into a workstation of the same name. So a netlist need not declare
/// the host computer.
void make_workstation(Completion& c, std::size_t index) {
    const auto& type = c.catalogue.node_types().find("workstation")->second;
    auto& edge = c.network.nodes[index];
    auto node = type.preset;
    node.name = edge.name;
    node.declared = edge.declared;
    edge = std::move(node);
    c.draft.links[index] = type.links;
    for (auto& wire : c.draft.wires)
        for (auto [near, far] : {std::pair(&wire.a, &wire.b), std::pair(&wire.b, &wire.a)})
            if (near->node == index) {
                near->link = 0; // an edge has one wire
                take_speed(edge, c.network.nodes[far->node]);
            }
}

/// Refuses edge channels on an edge where a process is placed: they would lead out of the network.
void refuse_edge_channels(Completion& c, const DraftProcess& process) {
    for (const auto& channel : c.draft.edge_channels)
        if (channel.edge == process.node)
            c.reporter.error(
                channel.placed,
                fmt::format("the edge channel \"{}\" is placed on \"{}\", which has the process \"{}\"", channel.name,
                            c.network.nodes[process.node].name, process.name),
                fmt::format("leave the edge channel out, and connect its other end with a channel of \"{}\"",
                            process.name),
                {{"the process is placed here", process.placed}});
}

bool is_on_edge(const Completion& c, const DraftProcess& process) {
    return process.node != nowhere && c.network.nodes[process.node].kind->links == LinkRole::edge;
}

} // namespace

void complete_hosts(Completion& c) {
    for (const auto& process : c.draft.processes)
        if (is_on_edge(c, process)) {
            refuse_edge_channels(c, process);
            make_workstation(c, process.node);
        }
}

} // namespace placedpar
