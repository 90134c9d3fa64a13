#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "runtime/time.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// The faults that every link can have.
const std::vector<FaultKind>& link_faults();

/// The fault of everything that answers on a bus.
FaultKind leaves_the_bus();
bool leaves_the_bus(const Fault&);

/// The attribute `from` of every fault, and `until` of one that passes; 0 stands for ever.
AttributeDescription fault_begins();
AttributeDescription fault_ends();
/// The attribute `until` of one that must pass.
AttributeDescription fault_must_end();

/// Return the times that `from` and `until` state.
Time begin_of(const Fault&);
Time end_of(const Fault&);

/// "20ms": a number of nanoseconds as the language writes it.
std::string print_nanoseconds(std::int64_t);

/// Returns the fault as its statement, without the first word: "t[0].link[1] silent (from = 20ms)". Attributes with
/// default values are left out.
std::string print_fault(const Fault&, const std::vector<Node>&);

/// Returns the text for a drawing: "silent from 20 ms", "slow, 4 times, until 1 s".
std::string print_fault_shortly(const Fault&);

/// Returns whether the fault affects this wire's link. Works in a network prepared for drawing (netlist/print), too.
bool strikes(const Fault&, const LinkConnection&);

} // namespace placedpar
