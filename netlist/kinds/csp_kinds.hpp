#pragma once

namespace placedpar {

class Catalogue;
struct ProcessKind;

/// Adds the small processes of the CSP textbooks, such as csp.producer, csp.identity, csp.prefix, csp.delta and
/// csp.consumer, and the kinds declared below. The textbook processes exchange Packets. They are useful in a first
/// netlist, to measure a link, and to demonstrate deadlocks.
void add_csp_kinds(Catalogue&);

/// csp_recovery.cpp: variants of csp.producer and csp.consumer whose time-outs let them survive a link that fails.
ProcessKind sender_or_fail_kind();
ProcessKind receiver_or_fail_kind();
/// switch_kinds.cpp: the logic of a C004, and a process that sets the switch.
ProcessKind switch_logic_kind();
ProcessKind switch_setter_kind();

} // namespace placedpar
