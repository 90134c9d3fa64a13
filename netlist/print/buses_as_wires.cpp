#include "netlist/print/buses_as_wires.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

LinkConnection line_of(const BusAttachment& attachment) {
    LinkConnection line;
    line.a.node = attachment.node;
    line.b = {attachment.bus, attachment.slot};
    line.bits_per_second = 0;
    line.name = attachment.name;
    line.connected = attachment.connected;
    return line;
}

/// Returns the hops of a way over a bus in the drawing: from the master to the bus, on to the slave, and over the
/// slave's wire if there is one. In the drawing, a line from a device to the bus is a connection. `lines` is the index
/// of the first of these connections.
std::vector<RouteHop> hops_over(const BusWay& way, const Network& network, std::size_t lines) {
    std::vector<RouteHop> hops{{lines + way.master, true}, {lines + way.slave, false}};
    if (way.wire != nowhere)
        hops.push_back({way.wire, network.connections[way.wire].a.node == network.attachments[way.slave].node});
    return hops;
}

void add_hops(std::vector<RouteHop>& route, const RouteHop& hop, const Network& network, std::size_t lines) {
    const auto& over_bus = network.connections[hop.connection].over_bus;
    if (!over_bus)
        return route.push_back(hop);
    std::vector<RouteHop> hops = hops_over(*over_bus, network, lines);
    if (!hop.from_a_to_b) {
        std::ranges::reverse(hops);
        for (RouteHop& each : hops)
            each.from_a_to_b = !each.from_a_to_b;
    }
    route.insert(route.end(), hops.begin(), hops.end());
}

} // namespace

Network with_buses_as_wires(Network network) {
    std::size_t wires = network.count_wires();
    for (NetworkChannel& channel : network.channels) {
        std::vector<RouteHop> route;
        for (const RouteHop& hop : channel.placement.route)
            add_hops(route, hop, network, wires);
        channel.placement.route = std::move(route);
    }
    network.connections.resize(wires);
    for (const BusAttachment& each : network.attachments)
        network.connections.push_back(line_of(each));
    return network;
}

} // namespace placedpar
