#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/machine_node.hpp"

#include <memory>

namespace placedpar {

/// These functions check and simulate a VMEbus. The bus's DeviceKind (vme.cpp) refers to them; vme_ways.cpp and
/// vme_node.cpp define them.

inline constexpr int vme_slots = 21;

/// Returns whether a device can be put into a slot, for Medium::takes: a slot holds at most one master, and the arbiter
/// must support the request level of the master. Otherwise reports the reason.
bool can_be_attached(const Attached&, const BusAttachment&);
/// Returns the ways over the bus, for Medium::ways. A way is a path of messages. It leads from a master to the memory
/// of a bus master, which is a transputer in a slot. Or it leads from the master that uses a link adapter to the
/// processor at the other end of the adapter's link.
std::vector<BusWay> ways_over_bus(const Attached&, std::size_t bus);

/// Makes the object that simulates the bus in a run, for DeviceKind::make.
std::unique_ptr<MachineNode> make_vme(MachineParts&, std::size_t node);

/// Returns whether the arbiter of the bus supports only request level 3.
bool has_single_level(const Node& bus);
/// Returns the slot of a master that a fault `hogged` adds to the bus. It is the highest empty slot, after the `taken`
/// highest empty slots have gone to other faults. Less than 1 if no slot is left.
int free_slot(const Network&, std::size_t bus, std::size_t taken);

} // namespace placedpar
