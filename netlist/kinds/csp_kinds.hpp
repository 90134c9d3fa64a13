#pragma once

namespace placedpar {

class Catalogue;
struct ProcessKind;

/// Adds the small processes of the CSP textbooks, over channels of counted byte arrays: csp.producer, csp.identity,
/// csp.prefix, csp.delta, csp.successor, csp.consumer. They serve for a first netlist, for measuring a link, and for
/// demonstrating deadlocks.
void add_csp_kinds(Catalogue&);

/// csp_recovery.cpp: variants of csp.producer and csp.consumer whose time-outs let them survive a link that fails.
ProcessKind sender_or_fail_kind();
ProcessKind receiver_or_fail_kind();
/// switch_kinds.cpp: the logic of a C004, and a process that sets the switch.
ProcessKind switch_logic_kind();
ProcessKind switch_setter_kind();

} // namespace placedpar
