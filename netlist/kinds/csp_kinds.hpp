#pragma once

namespace placedpar {

class Catalogue;
struct ProcessKind;

/// Adds kinds for the small processes of CSP textbooks, such as csp.producer, csp.identity, csp.prefix, csp.delta and
/// csp.consumer. Their messages are Packets. They are useful in a first netlist, to measure a link, and to demonstrate
/// deadlocks. Also adds the kinds declared below.
void add_csp_kinds(Catalogue&);

/// csp_recovery.cpp: kinds like csp.producer and csp.consumer, which give up a message after a time-out and so survive
/// a failing link.
ProcessKind sender_or_fail_kind();
ProcessKind receiver_or_fail_kind();
/// switch_kinds.cpp: a process that obeys the commands to a C004, a crossbar switch, and a process that sends these
/// commands.
ProcessKind switch_logic_kind();
ProcessKind switch_setter_kind();

} // namespace placedpar
