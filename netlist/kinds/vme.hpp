#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/machine_node.hpp"

#include <memory>

namespace placedpar {

/// Functions that the description of a VMEbus (vme.cpp) refers to; they are defined in vme_ways.cpp and vme_node.cpp.

inline constexpr int vme_slots = 21;

/// Checks an attachment, for Medium::takes: a slot holds at most one master, and the arbiter must support the master's
/// level.
bool can_be_attached(const Attached&, const BusAttachment&);
/// Returns the ways over the bus, for Medium::ways. A way leads from a master to the memory of a bus master, or from
/// the master that uses a link adapter to the processor at the other end of the adapter's link.
std::vector<BusWay> ways_over_bus(const Attached&, std::size_t bus);

/// Makes the bus of a run, for DeviceKind::make.
std::unique_ptr<MachineNode> make_vme(MachineParts&, std::size_t node);

/// Returns whether the arbiter of the bus supports level 3 only.
bool has_single_level(const Node& bus);
/// Returns the highest empty slot, after the `taken` highest empty slots are skipped; less than 1 if no slot is left.
int free_slot(const Network&, std::size_t bus, std::size_t taken);

} // namespace placedpar
