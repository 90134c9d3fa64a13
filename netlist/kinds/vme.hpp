#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/machine_node.hpp"

#include <memory>

namespace placedpar {

/// What the description of a VMEbus (vme.cpp) refers to: vme_ways.cpp, and in a run vme_node.cpp.

inline constexpr int vme_slots = 21;

/// For Medium::takes: a slot holds one master, which asks at a level that the arbiter knows.
bool can_be_attached(const Attached&, const BusAttachment&);
/// For Medium::ways: from each master to the memory of each bus master, and from the master that uses a link adapter to
/// what is at the other end of its link.
std::vector<BusWay> ways_over_bus(const Attached&, std::size_t bus);

/// For DeviceKind::make.
std::unique_ptr<MachineNode> make_vme(MachineParts&, std::size_t node);

/// Whether the arbiter of the bus knows level 3 only.
bool has_single_level(const Node& bus);
/// The highest slot of the bus in which nothing is, but for so many that are taken from there downwards; less than 1 if
/// there is none.
int free_slot(const Network&, std::size_t bus, std::size_t taken);

} // namespace placedpar
