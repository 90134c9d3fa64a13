#include "netlist/machine.hpp"
#include "runtime/hardware/link_adapter.hpp"

namespace placedpar {

namespace {

hardware::VmePlace place_of(const BusAttachment& attachment) {
    return {attachment.level, attachment.slot,
            attachment.on_request ? hardware::Release::on_request : hardware::Release::when_done};
}

} // namespace

void Machine::make_buses() {
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
    }
    for (std::size_t i = network_.count_wires(); i < network_.connections.size(); ++i)
        make_way(i);
}

void Machine::make_way(std::size_t index) {
    const BusWay& way = *network_.connections[index].over_bus;
    carriers_[index] = way.wire == nowhere ? make_memory_lanes(way) : make_adapter(way);
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

Machine::Carriers Machine::make_adapter(const BusWay& way) {
    using End = hardware::LinkAdapter::End;
    std::size_t node = network_.attachments[way.slave].node;
    End end = network_.connections[way.wire].a.node == node ? End::a : End::b;
    auto& adapter = simulation_.add<hardware::LinkAdapter>(network_.nodes[node].name, *links_[way.wire], end);
    auto& program = simulation_.add<hardware::AdapterProgram>(*masters_[way.master], adapter);
    return {&program.to_link(), &program.from_link()};
}

} // namespace placedpar
