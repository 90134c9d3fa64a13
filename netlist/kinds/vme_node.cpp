#include "netlist/kinds/on_vme.hpp"
#include "netlist/kinds/vme.hpp"
#include "netlist/network/names.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace placedpar {

namespace {

hardware::Arbitration arbitration_of(const Node& node) {
    const auto& arbiter = std::get<std::string>(node.attributes.at("arbiter"));
    return arbiter == "RRS"   ? hardware::Arbitration::round_robin
           : arbiter == "SGL" ? hardware::Arbitration::single_level
                              : hardware::Arbitration::priority;
}

Time nanoseconds_in(const Node& node, const char* attribute) {
    return std::chrono::nanoseconds{node.integer(attribute)};
}

hardware::VmeBus& make_bus(Simulation& simulation, const Node& node) {
    hardware::VmeTiming timing{.word = nanoseconds_in(node, "cycle"),
                               .byte = nanoseconds_in(node, "bytecycle"),
                               .arbitration = nanoseconds_in(node, "grant"),
                               .time_out = nanoseconds_in(node, "timeout")};
    return simulation.add<hardware::VmeBus>(node.name, arbitration_of(node), timing);
}

hardware::VmePlace place_of(const BusAttachment& attachment) {
    return {attachment.level, attachment.slot,
            attachment.on_request ? hardware::Release::on_request : hardware::Release::when_done};
}

/// Simulates a VMEbus, with its masters, memories and link adapters, and the ways over the bus: the paths of messages
/// from masters to slaves. REQUIRES: the nodes in its slots derive from OnVme.
class VmeNode final : public MachineNode {
public:
    VmeNode(MachineParts& parts, std::size_t index) : MachineNode(parts, index), bus_(make_bus(simulation(), node())) {
        for (std::size_t i = 0; i < network().attachments.size(); ++i)
            if (attachment(i).bus == index)
                attach(i);
    }

    CarrierPair carriers(std::size_t connection) override {
        const BusWay& way = *network().connections[connection].over_bus;
        return way.wire == nowhere ? memory_lanes(way) : adapter(connection);
    }

    void broadcast(const std::function<AnyChannel&(std::size_t)>& channel) override {
        broadcasts_ = broadcasts();
        for (Broadcast& each : broadcasts_) {
            std::vector<hardware::AdapterProgram*> programs;
            for (std::size_t i : each.channels)
                programs.push_back(adapters_.at(network().channels[i].placement.route.front().connection));
            each.writer = &simulation().add<hardware::AdapterBroadcast>(programs);
            for (std::size_t i = 0; i < each.channels.size(); ++i)
                each.writer->carry(channel(each.channels[i]), i);
        }
    }

    /// Simulates the fault `hogged`: adds a master that the netlist does not declare. This master requests the bus when
    /// the fault begins, and releases the bus when the fault ends.
    FaultEffects suffer(const Fault& fault) override {
        hardware::VmePlace place{static_cast<int>(fault.integer("level")), free_slot(network(), index(), hogs_++)};
        auto& master = simulation().add<hardware::VmeMaster>(fmt::format("slot {}", place.slot), bus_, place);
        Time from = begin_of(fault), until = end_of(fault);
        auto hog = [&master, from, until] {
            wait_until(from);
            master.hold_until(until);
        };
        simulation().process(print_fault(fault, network().nodes), hog).serve_machine();
        return [&master, from](FaultUse& use) {
            if (master.grants() > 0)
                use.held_since = from + master.time_waited();
        };
    }

    void report(MachineUse& use) const override {
        BusUse& row = use.buses.emplace_back(BusUse{bus_.name(), bus_.time_busy(), {}, {}});
        for (const hardware::VmeMaster* each : bus_.masters())
            row.masters.push_back({each->name(), each->place().level, each->words_moved(), each->bytes_accessed(),
                                   each->grants(), each->bus_errors(), each->time_waited(), each->longest_wait()});
        for (const Broadcast& each : broadcasts_) { // a broadcast is named by its port array
            const ChannelEnd& from = network().channels[each.channels.front()].from;
            row.broadcasts.push_back({network().processes[from.process].name + "." + std::string(base_name(from.port)),
                                      each.writer->adapters(), each.writer->messages(), each.writer->bytes()});
        }
    }

private:
    /// Holds the channels of one broadcast, which share each message.
    struct Broadcast {
        std::vector<std::size_t> channels;
        hardware::AdapterBroadcast* writer = nullptr;
    };
    const BusAttachment& attachment(std::size_t index) const { return network().attachments[index]; }

    OnVme& device(std::size_t index) const { return dynamic_cast<OnVme&>(*parts().nodes[attachment(index).node]); }

    void attach(std::size_t index) {
        const Node& node = network().nodes[attachment(index).node];
        OnVme& device = this->device(index);
        if (node.kind->is_master())
            masters_[index] =
                &simulation().add<hardware::VmeMaster>(node.name, bus_, place_of(attachment(index)), device.program);
        if (node.kind->bus == BusRole::bus_master)
            device.slave = device.memory = &simulation().add<hardware::DualPortedMemory>(node.name);
    }

    /// Returns what carries messages over a way through the memory of a bus master, a transputer on the bus, in both
    /// directions. A workstation writes and reads the bus master's memory, and converts the byte order. Of two bus
    /// masters, each writes to the other's memory.
    CarrierPair memory_lanes(const BusWay& way) {
        using From = hardware::MemoryLane::From;
        auto lane = [&](std::size_t master, std::size_t memory, From from, Cycles conversion) {
            return &simulation().add<hardware::MemoryLane>(*masters_[master], *device(memory).memory, from, conversion);
        };
        if (device(way.master).memory)
            return {lane(way.master, way.slave, From::master, Cycles{0}),
                    lane(way.slave, way.master, From::master, Cycles{0})};
        Cycles conversion{network().nodes[attachment(way.slave).node].integer("conversion")};
        return {lane(way.master, way.slave, From::master, conversion),
                lane(way.master, way.slave, From::memory, conversion)};
    }

    CarrierPair adapter(std::size_t connection) {
        using End = hardware::LinkAdapter::End;
        const BusWay& way = *network().connections[connection].over_bus;
        std::size_t index = attachment(way.slave).node;
        End end = network().connections[way.wire].a.node == index ? End::a : End::b;
        auto& adapter =
            simulation().add<hardware::LinkAdapter>(network().nodes[index].name, *parts().links[way.wire], end);
        device(way.slave).slave = &adapter;
        auto& program = simulation().add<hardware::AdapterProgram>(*masters_[way.master], adapter);
        adapters_[connection] = &program;
        return {&program.to_link(), &program.from_link()};
    }

    std::vector<Broadcast> broadcasts() const {
        std::vector<Broadcast> all;
        for (std::size_t i = 0; i < network().channels.size(); ++i) {
            const NetworkChannel& channel = network().channels[i];
            if (channel.placement.broadcast_on != index())
                continue;
            auto known = std::ranges::find_if(all, [&](const Broadcast& each) {
                return are_one_broadcast(network().channels[each.channels.front()], channel);
            });
            if (known == all.end())
                known = all.insert(known, Broadcast{});
            known->channels.push_back(i);
        }
        return all;
    }

    hardware::VmeBus& bus_;
    std::map<std::size_t, hardware::VmeMaster*> masters_; ///< key: index in Network::attachments
    std::map<std::size_t, hardware::AdapterProgram*>
        adapters_;                      ///< key: index in Network::connections of the way over the adapter
    std::vector<Broadcast> broadcasts_; ///< in the order of their first channels
    std::size_t hogs_ = 0;
};

} // namespace

std::unique_ptr<MachineNode> make_vme(MachineParts& parts, std::size_t node) {
    return std::make_unique<VmeNode>(parts, node);
}

} // namespace placedpar
