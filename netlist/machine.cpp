#include "netlist/machine.hpp"

#include "netlist/network/names.hpp"

namespace placedpar {

namespace {

/// Hundredths of a bit time that a bit needs to cross the switches on its way.
std::int64_t crossing_delay(const LinkConnection& connection, const std::vector<Node>& nodes) {
    std::int64_t hundredths = 0;
    for (const SwitchCrossing& crossing : connection.crossings)
        hundredths += nodes[crossing.node].kind->crossing_delay;
    return hundredths;
}

Time wire_delay(const LinkConnection& connection, const std::vector<Node>& nodes) {
    constexpr auto metre = static_cast<double>(hardware::LinkTiming::metre_of_wire.count());
    return Time{static_cast<std::int64_t>(connection.metres * metre)} +
           duration_of(crossing_delay(connection, nodes), 100 * connection.bits_per_second);
}

/// A link overlaps its acknowledges where both of its ends can.
hardware::LinkTiming timing_of(const LinkConnection& connection, const std::vector<Node>& nodes) {
    hardware::LinkTiming timing{.bits_per_second = connection.bits_per_second,
                                .wire_delay = wire_delay(connection, nodes)};
    for (const LinkEnd& end : {connection.a, connection.b})
        timing.overlapped_acknowledge = timing.overlapped_acknowledge && nodes[end.node].overlapped_acknowledge;
    return timing;
}

hardware::Link& add_link(Simulation& simulation, const LinkConnection& connection, const std::vector<Node>& nodes) {
    return simulation.add<hardware::Link>(timing_of(connection, nodes), link_name(nodes, connection.a),
                                          link_name(nodes, connection.b));
}

bool travels_in_packets(const NetworkChannel& channel) {
    return channel.placement.kind == ChannelPlacement::Kind::link && channel.placement.in_packets;
}

} // namespace

Machine::Machine(const Network& network, const Catalogue& catalogue, std::uint64_t seed)
    : network_(network), software_(network_, catalogue, seed) {
    make_executives();
    make_links();
    make_buses();
    make_faults();
    make_routers();
    place_channels();
    start_processes();
}

void Machine::make_executives() {
    for (std::size_t i = 0; i < network_.nodes.size(); ++i) {
        const DeviceKind& kind = *network_.nodes[i].kind;
        bool differs = kind.make_executive_on_bus && is_on_bus(network_, i);
        const auto& make = differs ? kind.make_executive_on_bus : kind.make_executive;
        executives_.push_back(make ? make(simulation_, network_.nodes[i]) : NodeExecutive{});
    }
}

void Machine::make_links() {
    carriers_.resize(network_.connections.size());
    for (const LinkConnection& connection : network_.connections) {
        if (connection.over_bus) {
            links_.push_back(nullptr);
            continue;
        }
        links_.push_back(&add_link(simulation_, connection, network_.nodes));
        carriers_[links_.size() - 1] = {&links_.back()->from_a_to_b(), &links_.back()->from_b_to_a()};
        if (connection.at_run_time)
            make_switched(links_.size() - 1);
        for (const LinkEnd& end : {connection.a, connection.b})
            if (const auto& has_link = executives_[end.node].has_link)
                has_link(*links_.back());
    }
}

/// The switches that a program sets decide what gets over; the engines at its ends may be those of other links, too.
void Machine::make_switched(std::size_t index) {
    const LinkConnection& connection = network_.connections[index];
    hardware::Link& link = *links_[index];
    for (const SwitchCrossing& crossing : connection.crossings)
        if (is_set_at_run_time(network_, crossing.node))
            executives_[crossing.node].crossbar->lead_on(link, crossing.from_link, crossing.to_link);
    auto lane = [&](hardware::LinkDirection& direction, const LinkEnd& from, const LinkEnd& to) {
        return &simulation_.add<hardware::SwitchedLane>(direction, engine_at(from, true), engine_at(to, false));
    };
    carriers_[index] = {lane(link.from_a_to_b(), connection.a, connection.b),
                        lane(link.from_b_to_a(), connection.b, connection.a)};
}

hardware::SharedEngine& Machine::engine_at(const LinkEnd& end, bool outputs) {
    return engines_.try_emplace({end.node, end.link, outputs}, hardware::SharedEngine{link_name(network_.nodes, end)})
        .first->second;
}

void Machine::make_routers() {
    for (const NodeExecutive& each : executives_)
        routers_.push_back(&simulation_.add<hardware::Router>(each.executive));
    router_links_.resize(links_.size());
    for (const NetworkChannel& channel : network_.channels)
        if (travels_in_packets(channel))
            for (const RouteHop& hop : channel.placement.route)
                if (auto& link = router_links_[hop.connection]; !link)
                    link = &make_router_link(hop.connection);
}

hardware::RouterLink& Machine::make_router_link(std::size_t index) {
    const LinkConnection& connection = network_.connections[index];
    return simulation_.add<hardware::RouterLink>(lane(index, true), lane(index, false), *routers_[connection.a.node],
                                                 *routers_[connection.b.node]);
}

hardware::Lane Machine::lane(std::size_t index, bool from_a_to_b) const {
    const LinkConnection& connection = network_.connections[index];
    std::string a = link_name(network_.nodes, connection.a), b = link_name(network_.nodes, connection.b);
    const Carriers& both = carriers_[index];
    return from_a_to_b ? hardware::Lane{*both.from_a_to_b, a + " -> " + b}
                       : hardware::Lane{*both.from_b_to_a, b + " -> " + a};
}

void Machine::place_channels() {
    routes_.resize(network_.channels.size());
    for (std::size_t i = 0; i < network_.channels.size(); ++i)
        if (const ChannelPlacement& at = network_.channels[i].placement;
            at.kind == ChannelPlacement::Kind::link && at.broadcast_on == nowhere)
            carry(i);
    for (const Broadcast& each : broadcasts_)
        for (std::size_t i = 0; i < each.channels.size(); ++i)
            each.writer->carry(software_.channel(each.channels[i]), i);
}

void Machine::carry(std::size_t index) {
    AnyChannel& channel = software_.channel(index);
    std::vector<hardware::Hop> hops;
    for (auto [connection, forth] : network_.channels[index].placement.route) {
        if (!router_links_[connection]) // then there is no other hop
            return channel.put_on(forth ? *carriers_[connection].from_a_to_b : *carriers_[connection].from_b_to_a);
        hops.push_back({*router_links_[connection], forth});
    }
    auto& route = simulation_.add<hardware::Route>(hops);
    channel.put_on(route);
    routes_[index] = &route;
}

void Machine::record(RecordedRun& record) {
    record_ = &record;
    for (Process* process : software_.processes())
        process->keep(record.histories.emplace_back(record.course, record.histories.size()));
}

void Machine::start_processes() {
    std::vector<Executive*> executives;
    for (const NodeExecutive& each : executives_)
        executives.push_back(each.executive);
    software_.start(simulation_, executives);
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        if (network_.nodes[network_.processes[i].node].kind->is_set_by_link())
            software_.processes()[i]->serve_machine(); // it is a part of the switch, and never ends
}

} // namespace placedpar
