#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "runtime/time.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Returns the kinds of faults that every link can have, such as `silent`. A `fault` statement of a netlist gives a
/// fault to a link or a device.
const std::vector<FaultKind>& link_faults();

/// Returns the kind of fault `absent`, which every device that answers accesses on a bus can have: the device stops
/// answering.
FaultKind leaves_the_bus();
bool leaves_the_bus(const Fault&);

/// These two functions describe the attribute `from` of every fault, and the attribute `until` of a fault that may last
/// for ever. A fault with `until = 0` lasts for ever.
AttributeDescription fault_begins();
AttributeDescription fault_ends();
/// Describes the attribute `until` of a fault that must end.
AttributeDescription fault_must_end();

/// These two functions return the values of the attributes `from` and `until` of a fault.
Time begin_of(const Fault&);
Time end_of(const Fault&);

/// Returns a time in ns as text of the netlist language, such as "20ms".
std::string print_nanoseconds(std::int64_t);

/// Returns the `fault` statement without its first word: "t[0].link[1] silent (from = 20ms)". Attributes with default
/// values are left out.
std::string print_fault(const Fault&, const std::vector<Node>&);

/// Returns a text for a drawing, such as "silent from 20 ms" or "slow, 4 times, until 1 s".
std::string print_fault_shortly(const Fault&);

/// Returns whether the fault affects this wire. The network may also be one that is prepared for drawing, such as by
/// with_buses_as_wires() (netlist/print).
bool strikes(const Fault&, const LinkConnection&);

} // namespace placedpar
