#pragma once

#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/machine_use.hpp"
#include "netlist/kinds/program_waits.hpp"
#include "netlist/network/network.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/switched_lane.hpp"
#include "runtime/simulation.hpp"
#include "runtime/trace.hpp"
#include "text/reporter.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace placedpar {

namespace hardware {
class Router; // runtime/hardware/router.hpp
struct RouterCosts;
} // namespace hardware

class MachineNode;

/// Holds the parts of a simulated machine that have been made so far. Devices without slots are made first, then links,
/// then devices with slots, such as buses. Each part may use the parts made before it.
struct MachineParts {
    Simulation& simulation;
    const Network& network;
    std::vector<std::unique_ptr<MachineNode>> nodes; ///< one for each node
    std::vector<hardware::Link*> links; ///< one for each connection; null for a way over a device with slots
};

/// Holds what carries messages over a connection, such as a wire or a way over a bus: one carrier for each direction.
struct CarrierPair {
    Carrier *from_a_to_b = nullptr, *from_b_to_a = nullptr;
};

/// Adds the effects of a device's fault to the report after the run. Empty if the fault only stops processes.
using FaultEffects = std::function<void(FaultUse&)>;

/// Simulates a node of the network in a run. DeviceKind::make makes the object. The base class does nothing; a device
/// overrides the functions that it needs. A device that takes time adds processes and hardware to the simulation. The
/// object outlives the simulation.
class MachineNode {
public:
    /// REQUIRES: the parts outlive this object.
    MachineNode(MachineParts& parts, std::size_t node) : parts_(parts), node_(node) {}
    MachineNode(const MachineNode&) = delete;
    MachineNode& operator=(const MachineNode&) = delete;
    virtual ~MachineNode() = default;

    /// Returns the processor that executes the processes on the node; null if they take no time.
    virtual Executive* executive() { return nullptr; }
    /// Called before the run for each link that ends at the node.
    virtual void has_link(hardware::Link&) {}
    /// Returns the delay of a bit that passes through this device, a switch, in hundredths of a bit time; 0 for other
    /// devices.
    virtual std::int64_t crossing_delay() const { return 0; }
    /// Called before the run for each connection through a switch that programs set: the connection exists while the
    /// switch connects the two links of this crossing. REQUIRES: DeviceKind::is_set_by_link().
    virtual void lead_on(hardware::Link&, const SwitchCrossing&) {}
    /// Returns what carries messages over this way, a path from one device in a slot to another. REQUIRES: the device
    /// has slots, and the connection is one of its ways (Medium::ways).
    virtual CarrierPair carriers(std::size_t connection);
    /// Puts a channel on a wire. One end of the channel is at a process in C++; at the other end, the machine code of
    /// this node sends or receives the messages. REQUIRES: this node executes machine code; the channel leads over this
    /// hop.
    virtual void carry(AnyChannel&, const RouteHop&);
    /// For a bus: prepares the channels that are broadcast on it (ChannelPlacement::broadcast_on). The function returns
    /// a channel by its index.
    virtual void broadcast(const std::function<AnyChannel&(std::size_t)>& /* channel */) {}
    /// Makes the device execute the ready processes of its machine code in a random order. Called before the run.
    virtual void shuffle(std::uint64_t /* seed */) {}
    /// Called before the run for each fault of the device.
    virtual FaultEffects suffer(const Fault&) { return {}; }
    /// Adds the device's part to the report. Called after the run.
    virtual void report(MachineUse&) const {}
    /// Returns the waiting processes of the device's machine code. Called after a run that ended in a deadlock.
    virtual std::vector<ProgramWait> program_waits() const { return {}; }

    /// Returns the engine that transfers messages between the node's memory and a link that a switch connects to
    /// several partners in turn.
    hardware::SharedEngine& engine(int link, bool outputs);
    /// Returns the router, which passes packets on over the node's links. The first call makes the router.
    hardware::Router& router();

protected:
    const Network& network() const { return parts_.network; }
    const Node& node() const { return parts_.network.nodes[node_]; }
    std::size_t index() const { return node_; }
    const MachineParts& parts() const { return parts_; }
    Simulation& simulation() const { return parts_.simulation; }
    /// Returns the router; null if the node handles no packets.
    const hardware::Router* router_if_any() const { return router_; }
    /// Returns the priority of the router's processes, and the processor time for each packet.
    virtual hardware::RouterCosts router_costs() const;

private:
    MachineParts& parts_;
    std::size_t node_;
    hardware::Router* router_ = nullptr;
    std::map<std::pair<int, bool>, hardware::SharedEngine>
        engines_; ///< key: number of the link, and whether the engine outputs
};

/// Makes a device of this class, for DeviceKind::make.
template <class Device>
std::unique_ptr<MachineNode> make_device(MachineParts& parts, std::size_t node) {
    return std::make_unique<Device>(parts, node);
}

} // namespace placedpar
