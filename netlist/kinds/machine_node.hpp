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

/// Holds the parts of a run that have been made so far. Devices without slots are made first, then the links, then the
/// devices with slots. Each part may use the parts made before it.
struct MachineParts {
    Simulation& simulation;
    const Network& network;
    std::vector<std::unique_ptr<MachineNode>> nodes; ///< one for each node
    std::vector<hardware::Link*> links; ///< one for each connection; null for ways over a device with slots
};

/// Holds the two carriers of the channels over a connection, one for each direction.
struct CarrierPair {
    Carrier *from_a_to_b = nullptr, *from_b_to_a = nullptr;
};

/// Adds the effects of a device's fault to the report. The function is empty if the fault only stops processes.
using FaultEffects = std::function<void(FaultUse&)>;

/// Simulates a node of the network in a run. The node's DeviceKind makes it. The base class does nothing; a device
/// overrides the functions that it needs. A device that takes time adds processes and hardware to the simulation. All
/// devices outlive the simulation.
class MachineNode {
public:
    /// REQUIRES: the parts outlive this object.
    MachineNode(MachineParts& parts, std::size_t node) : parts_(parts), node_(node) {}
    MachineNode(const MachineNode&) = delete;
    MachineNode& operator=(const MachineNode&) = delete;
    virtual ~MachineNode() = default;

    /// Returns the executive of the processes on the node; null if they take no time.
    virtual Executive* executive() { return nullptr; }
    /// Tells the device that the link ends at the node. Called before the run.
    virtual void has_link(hardware::Link&) {}
    /// Returns the delay of a bit that crosses the device, in hundredths of a bit time; 0 if no wires cross the device.
    virtual std::int64_t crossing_delay() const { return 0; }
    /// Tells the device that a link leads through it while the device connects this crossing. REQUIRES:
    /// DeviceKind::is_set_by_link().
    virtual void lead_on(hardware::Link&, const SwitchCrossing&) {}
    /// Returns the carriers of the channels over this way. REQUIRES: the device has slots, and the connection is one of
    /// its ways (Medium::ways).
    virtual CarrierPair carriers(std::size_t connection);
    /// Puts the channel on a wire between a process and the node's own code, which sends or receives the messages.
    /// REQUIRES: the node runs its own code; the channel leads over this hop (NetworkChannel).
    virtual void carry(AnyChannel&, const RouteHop&);
    /// Puts the channels that are broadcast on the device (ChannelPlacement::broadcast_on) on their carriers.
    virtual void broadcast(const std::function<AnyChannel&(std::size_t)>& /* channel */) {}
    /// Makes the device run the ready processes of its own code in a random order. Called before the run.
    virtual void shuffle(std::uint64_t /* seed */) {}
    /// Tells the device that it has this fault in this run. Called before the run.
    virtual FaultEffects suffer(const Fault&) { return {}; }
    /// Adds the device's part of the report. Called when the work of the run is over.
    virtual void report(MachineUse&) const {}
    /// Returns the processes of the device's own program that wait. Called after a run that ended in a deadlock.
    virtual std::vector<ProgramWait> program_waits() const { return {}; }

    /// Returns the engine of a link whose partner changes during the run.
    hardware::SharedEngine& engine(int link, bool outputs);
    /// Returns the router that passes packets on over the node's links. The first call makes the router.
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
        engines_; ///< key: link number; true for the engine that outputs
};

/// Makes a device of this class, for DeviceKind::make.
template <class Device>
std::unique_ptr<MachineNode> make_device(MachineParts& parts, std::size_t node) {
    return std::make_unique<Device>(parts, node);
}

} // namespace placedpar
