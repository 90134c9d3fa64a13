#include "netlist/machine.hpp"
#include "netlist/network/names.hpp"

#include <algorithm>

namespace placedpar {

namespace {

hardware::VmePlace place_of(const BusAttachment& attachment) {
    return {attachment.level, attachment.slot,
            attachment.on_request ? hardware::Release::on_request : hardware::Release::when_done};
}

} // namespace

void Machine::make_buses() {
    slaves_.resize(network_.nodes.size());
    for (const Node& node : network_.nodes)
        buses_.push_back(node.kind->make_bus ? &node.kind->make_bus(simulation_, node) : nullptr);
    for (const BusAttachment& each : network_.attachments) {
        const Node& node = network_.nodes[each.node];
        const DeviceKind& kind = *node.kind;
        masters_.push_back(kind.is_master() ? &simulation_.add<hardware::VmeMaster>(node.name, *buses_[each.bus],
                                                                                    place_of(each), kind.bus_program)
                                            : nullptr);
        memories_.push_back(kind.bus == BusRole::bus_master ? &simulation_.add<hardware::DualPortedMemory>(node.name)
                                                            : nullptr);
        slaves_[each.node] = memories_.back();
    }
    for (std::size_t i = network_.count_wires(); i < network_.connections.size(); ++i)
        make_way(i);
    make_broadcasts();
}

void Machine::make_way(std::size_t index) {
    const BusWay& way = *network_.connections[index].over_bus;
    carriers_[index] = way.wire == nowhere ? make_memory_lanes(way) : make_adapter(index);
}

/// A workstation writes to the bus master's memory and reads there, and their bytes are in different orders. Of two bus
/// masters each writes to the other's.
Machine::Carriers Machine::make_memory_lanes(const BusWay& way) {
    using From = hardware::MemoryLane::From;
    auto lane = [&](std::size_t master, std::size_t memory, From from, Cycles conversion) {
        return &simulation_.add<hardware::MemoryLane>(*masters_[master], *memories_[memory], from, conversion);
    };
    if (memories_[way.master])
        return {lane(way.master, way.slave, From::master, Cycles{0}),
                lane(way.slave, way.master, From::master, Cycles{0})};
    Cycles conversion{network_.nodes[network_.attachments[way.slave].node].integer("conversion")};
    return {lane(way.master, way.slave, From::master, conversion),
            lane(way.master, way.slave, From::memory, conversion)};
}

Machine::Carriers Machine::make_adapter(std::size_t index) {
    using End = hardware::LinkAdapter::End;
    const BusWay& way = *network_.connections[index].over_bus;
    std::size_t node = network_.attachments[way.slave].node;
    End end = network_.connections[way.wire].a.node == node ? End::a : End::b;
    auto& adapter = simulation_.add<hardware::LinkAdapter>(network_.nodes[node].name, *links_[way.wire], end);
    slaves_[node] = &adapter;
    auto& program = simulation_.add<hardware::AdapterProgram>(*masters_[way.master], adapter);
    adapters_[index] = &program;
    return {&program.to_link(), &program.from_link()};
}

void Machine::make_broadcasts() {
    for (std::size_t i = 0; i < network_.channels.size(); ++i)
        if (network_.channels[i].placement.broadcast_on != nowhere)
            add_to_broadcast(i);
    for (Broadcast& broadcast : broadcasts_) {
        std::vector<hardware::AdapterProgram*> programs;
        for (std::size_t channel : broadcast.channels)
            programs.push_back(adapters_.at(network_.channels[channel].placement.route.front().connection));
        broadcast.writer = &simulation_.add<hardware::AdapterBroadcast>(programs);
    }
}

void Machine::add_to_broadcast(std::size_t channel) {
    auto known = std::ranges::find_if(broadcasts_, [&](const Broadcast& each) {
        return are_one_broadcast(network_.channels[each.channels.front()], network_.channels[channel]);
    });
    if (known == broadcasts_.end())
        known = broadcasts_.insert(known, Broadcast{});
    known->channels.push_back(channel);
}

/// Of a bus, named by the port array.
std::vector<BroadcastUse> Machine::broadcast_uses(const hardware::VmeBus& bus) const {
    std::vector<BroadcastUse> uses;
    for (const Broadcast& each : broadcasts_) {
        const NetworkChannel& first = network_.channels[each.channels.front()];
        if (buses_[first.placement.broadcast_on] == &bus)
            uses.push_back({network_.processes[first.from.process].name + "." + std::string(base_name(first.from.port)),
                            each.writer->adapters(), each.writer->messages(), each.writer->bytes()});
    }
    return uses;
}

} // namespace placedpar
