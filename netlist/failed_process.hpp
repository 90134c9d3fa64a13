#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "runtime/deadlock.hpp"
#include "runtime/kernel.hpp"

namespace placedpar {

/// Rethrows the current exception, which a process of a run threw, with the name of this process and the place of its
/// declaration. If a user can cause the error, the new exception is a UserError; otherwise it is a std::logic_error,
/// which reports a defect of PlacedPar. A std::system_error or std::bad_alloc from PlacedPar's own code is rethrown
/// unchanged.
[[noreturn]] void rethrow_with_process(const Failure&, const Network&, const Catalogue&);

/// Completes the report of a deadlock. Adds the places where the netlist declares the stuck processes and connects the
/// stuck channels. Sorts the channels: channels of the netlist come first, in the order of the netlist. Channels that
/// processes made during the run follow.
void add_places(Deadlock&, const Network&);

} // namespace placedpar
