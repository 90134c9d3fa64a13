#pragma once

#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/machine_use.hpp"
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

/// Holds what a run is made of so far. First come the devices without slots, then the links, then the devices with
/// slots: each may ask for those before it.
struct MachineParts {
    Simulation& simulation;
    const Network& network;
    std::vector<std::unique_ptr<MachineNode>> nodes; ///< by node
    std::vector<hardware::Link*> links;              ///< by connection; null for ways over a device with slots
};

/// These carry the channels over a connection.
struct CarrierPair {
    Carrier *from_a_to_b = nullptr, *from_b_to_a = nullptr;
};

/// Adds to the report what a fault of a device did in the run; empty where it does nothing else than stop processes.
using FaultEffects = std::function<void(FaultUse&)>;

/// A node of the network in a run, made by its DeviceKind. As it stands it does nothing: a device overrides what it
/// does. It adds to the simulation what takes time, and outlives the simulation.
class MachineNode {
public:
    /// REQUIRES: the parts outlive it.
    MachineNode(MachineParts& parts, std::size_t node) : parts_(parts), node_(node) {}
    MachineNode(const MachineNode&) = delete;
    MachineNode& operator=(const MachineNode&) = delete;
    virtual ~MachineNode() = default;

    /// Executes the processes that are placed on the node; null: they take no time.
    virtual Executive* executive() { return nullptr; }
    /// A link ends at the node. Called before the run.
    virtual void has_link(hardware::Link&) {}
    /// Returns what a bit needs to cross it, where wires do, in hundredths of a bit time.
    virtual std::int64_t crossing_delay() const { return 0; }
    /// A link leads through it when it is set so during the run. REQUIRES: its kind is set by a link.
    virtual void lead_on(hardware::Link&, const SwitchCrossing&) {}
    /// Returns what carries channels over a way of Medium::ways. REQUIRES: it has slots, and the way is its own.
    virtual CarrierPair carriers(std::size_t connection);
    /// Puts the channels that are broadcast on it (ChannelPlacement::broadcast_on) on their carriers.
    virtual void broadcast(const std::function<AnyChannel&(std::size_t)>& /* channel */) {}
    /// The device has the fault, of its kind, in this run. Called before the run.
    virtual FaultEffects suffer(const Fault&) { return {}; }
    /// Adds what it reports. Called when the work of the run is over.
    virtual void report(MachineUse&) const {}

    /// Returns an engine of a link that is connected to one partner after the other.
    hardware::SharedEngine& engine(int link, bool outputs);
    /// Passes packets on by its links; made when it is first asked for.
    hardware::Router& router();

protected:
    const Network& network() const { return parts_.network; }
    const Node& node() const { return parts_.network.nodes[node_]; }
    std::size_t index() const { return node_; }
    const MachineParts& parts() const { return parts_; }
    Simulation& simulation() const { return parts_.simulation; }
    /// Null where no channel leads there in packets.
    const hardware::Router* router_if_any() const { return router_; }
    /// What its router asks of its executive.
    virtual hardware::RouterCosts router_costs() const;

private:
    MachineParts& parts_;
    std::size_t node_;
    hardware::Router* router_ = nullptr;
    std::map<std::pair<int, bool>, hardware::SharedEngine> engines_; ///< by link and whether it outputs
};

/// For DeviceKind::make.
template <class Device>
std::unique_ptr<MachineNode> make_device(MachineParts& parts, std::size_t node) {
    return std::make_unique<Device>(parts, node);
}

} // namespace placedpar
