#include "netlist/machine.hpp"

#include "netlist/network/names.hpp"

namespace placedpar {

namespace {

/// Returns the timing of a link. The link sends the acknowledge of a byte while the byte arrives, if both ends can do
/// so.
hardware::LinkTiming timing_of(const LinkConnection& connection, const MachineParts& parts) {
    constexpr auto metre = static_cast<double>(hardware::LinkTiming::metre_of_wire.count());
    std::int64_t crossing = 0; // hundredths of a bit time
    for (const SwitchCrossing& each : connection.crossings)
        crossing += parts.nodes[each.node]->crossing_delay();
    hardware::LinkTiming timing{.bits_per_second = connection.bits_per_second,
                                .wire_delay = Time{static_cast<std::int64_t>(connection.metres * metre)} +
                                              duration_of(crossing, 100 * connection.bits_per_second)};
    for (const LinkEnd& end : {connection.a, connection.b})
        timing.overlapped_acknowledge &= parts.network.nodes[end.node].overlapped_acknowledge;
    return timing;
}

bool travels_in_packets(const NetworkChannel& channel) {
    return channel.placement.kind == ChannelPlacement::Kind::link && channel.placement.in_packets;
}

} // namespace

Machine::Machine(const Network& network, const Catalogue& catalogue, std::uint64_t seed)
    : network_(with_code_inside(network)), software_(network_, catalogue, seed) {
    make_nodes(false);
    make_links();
    make_nodes(true);
    make_ways();
    make_faults();
    make_router_links();
    place_channels();
    start_processes();
}

/// Makes the nodes with slots, such as buses, or the nodes without slots. Nodes with slots are made later, since they
/// use the devices in their slots.
void Machine::make_nodes(bool with_slots) {
    parts_.nodes.resize(network_.nodes.size());
    for (std::size_t i = 0; i < network_.nodes.size(); ++i)
        if (const DeviceKind& kind = *network_.nodes[i].kind; kind.medium.has_value() == with_slots)
            parts_.nodes[i] = kind.make ? ask_device(network_.nodes[i], [&] { return kind.make(parts_, i); })
                                        : std::make_unique<MachineNode>(parts_, i);
}

void Machine::make_links() {
    connections_.resize(network_.connections.size());
    for (const LinkConnection& connection : network_.connections)
        if (connection.over_bus)
            parts_.links.push_back(nullptr);
        else
            make_link(connection);
}

void Machine::make_link(const LinkConnection& connection) {
    auto& link = simulation_.add<hardware::Link>(timing_of(connection, parts_), link_name(network_.nodes, connection.a),
                                                 link_name(network_.nodes, connection.b));
    const std::size_t index = parts_.links.size();
    parts_.links.push_back(&link);
    connections_[index].carriers =
        connection.at_run_time ? switched(index) : CarrierPair{&link.from_a_to_b(), &link.from_b_to_a()};
    for (const LinkEnd& end : {connection.a, connection.b})
        ask(end.node, &MachineNode::has_link, link);
}

/// Returns what carries messages, in both directions, over a connection that switches make during the run. The
/// connection shares the engines of its two links with the other connections that switches make at these links.
CarrierPair Machine::switched(std::size_t index) {
    const LinkConnection& connection = network_.connections[index];
    hardware::Link& link = *parts_.links[index];
    for (const SwitchCrossing& crossing : connection.crossings)
        if (is_set_at_run_time(network_, crossing.node))
            parts_.nodes[crossing.node]->lead_on(link, crossing);
    auto lane = [&](hardware::LinkDirection& direction, const LinkEnd& from, const LinkEnd& to) {
        return &simulation_.add<hardware::SwitchedLane>(direction, parts_.nodes[from.node]->engine(from.link, true),
                                                        parts_.nodes[to.node]->engine(to.link, false));
    };
    return {lane(link.from_a_to_b(), connection.a, connection.b), lane(link.from_b_to_a(), connection.b, connection.a)};
}

void Machine::make_ways() {
    for (std::size_t i = network_.count_wires(); i < network_.connections.size(); ++i) {
        std::size_t master = network_.connections[i].over_bus->master;
        connections_[i].carriers = ask(network_.attachments[master].bus, &MachineNode::carriers, i);
    }
}

void Machine::make_router_links() {
    for (const NetworkChannel& channel : network_.channels)
        if (travels_in_packets(channel))
            for (const RouteHop& hop : channel.placement.route)
                if (auto& link = connections_[hop.connection].router_link; !link)
                    link = &make_router_link(hop.connection);
}

hardware::RouterLink& Machine::make_router_link(std::size_t index) {
    const LinkConnection& connection = network_.connections[index];
    return simulation_.add<hardware::RouterLink>(lane(index, true), lane(index, false),
                                                 parts_.nodes[connection.a.node]->router(),
                                                 parts_.nodes[connection.b.node]->router());
}

hardware::RouterLane Machine::lane(std::size_t index, bool from_a_to_b) const {
    const LinkConnection& connection = network_.connections[index];
    std::string a = link_name(network_.nodes, connection.a), b = link_name(network_.nodes, connection.b);
    const CarrierPair& both = connections_[index].carriers;
    return from_a_to_b ? hardware::RouterLane{*both.from_a_to_b, a + " -> " + b}
                       : hardware::RouterLane{*both.from_b_to_a, b + " -> " + a};
}

void Machine::place_channels() {
    routes_.resize(network_.channels.size());
    for (std::size_t i = 0; i < network_.channels.size(); ++i)
        if (const NetworkChannel& channel = network_.channels[i]; channel.end_at_code())
            ask(channel.end_at_code()->node, &MachineNode::carry, software_.channel(i),
                channel.placement.route.front());
        else if (channel.placement.kind == ChannelPlacement::Kind::link && channel.placement.broadcast_on == nowhere)
            carry(i);
    auto channel = [this](std::size_t index) -> AnyChannel& { return software_.channel(index); };
    for (std::size_t i = 0; i < parts_.nodes.size(); ++i)
        ask(i, &MachineNode::broadcast, channel);
}

void Machine::carry(std::size_t index) {
    AnyChannel& channel = software_.channel(index);
    std::vector<hardware::Hop> hops;
    for (auto [connection, forth] : network_.channels[index].placement.route) {
        const auto& [carriers, router_link] = connections_[connection];
        if (!router_link) // a channel that is not sent in packets has a single hop
            return channel.put_on(forth ? *carriers.from_a_to_b : *carriers.from_b_to_a);
        hops.push_back({*router_link, forth});
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
    for (std::size_t i = 0; i < parts_.nodes.size(); ++i)
        executives.push_back(ask(i, &MachineNode::executive));
    software_.start(simulation_, executives);
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        if (network_.nodes[network_.processes[i].node].kind->is_set_by_link())
            software_.processes()[i]->serve_machine(); // the process is the switch's logic and never ends
}

void Machine::shuffle(std::uint64_t seed) {
    simulation_.shuffle(seed);
    for (const auto& node : parts_.nodes)
        node->shuffle(seed);
}

} // namespace placedpar
