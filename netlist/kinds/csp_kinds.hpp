#pragma once

namespace placedpar {

class Catalogue;
struct ProcessKind;

/// Adds the small processes of the CSP textbooks, over channels of counted byte arrays: csp.producer, csp.identity,
/// csp.prefix, csp.delta, csp.successor, csp.consumer. They serve for a first netlist, for measuring a link, and for
/// demonstrating deadlocks.
void add_csp_kinds(Catalogue&);

/// csp_recovery.cpp: csp.producer and csp.consumer with time-outs, which survive a link that fails.
ProcessKind sender_or_fail_kind();
ProcessKind receiver_or_fail_kind();
/// switch_kinds.cpp: the logic of a C004, and a producer that sets it.
ProcessKind switch_logic_kind();
ProcessKind switch_setter_kind();

} // namespace placedpar
