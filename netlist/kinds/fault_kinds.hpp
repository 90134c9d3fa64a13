#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "runtime/time.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Returns the faults that every link can have.
const std::vector<FaultKind>& link_faults();

/// Returns the fault `absent`, which every device that answers on a bus can have.
FaultKind leaves_the_bus();
bool leaves_the_bus(const Fault&);

/// Returns the attribute `from` of every fault, and the attribute `until` of a fault that may end; 0 means never.
AttributeDescription fault_begins();
AttributeDescription fault_ends();
/// Returns the attribute `until` of a fault that must end.
AttributeDescription fault_must_end();

/// These two functions return the times of the attributes `from` and `until`.
Time begin_of(const Fault&);
Time end_of(const Fault&);

/// Returns the time in the netlist language, such as "20ms".
std::string print_nanoseconds(std::int64_t);

/// Returns the fault as its statement, without the first word: "t[0].link[1] silent (from = 20ms)". Attributes with
/// default values are left out.
std::string print_fault(const Fault&, const std::vector<Node>&);

/// Returns the text for a drawing: "silent from 20 ms", "slow, 4 times, until 1 s".
std::string print_fault_shortly(const Fault&);

/// Returns whether the fault affects the link of this wire. Also works in a network prepared for drawing
/// (netlist/print).
bool strikes(const Fault&, const LinkConnection&);

} // namespace placedpar
