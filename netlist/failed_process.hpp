#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "runtime/deadlock.hpp"
#include "runtime/kernel.hpp"

namespace placedpar {

/// Rethrows the current exception with the name and declaration of the process that threw it. The new exception is a
/// UserError if a user can cause the error; otherwise it is a logic_error, which reports a defect of PlacedPar. A
/// std::system_error is rethrown unchanged.
[[noreturn]] void rethrow_with_process(const Failure&, const Network&, const Catalogue&);

/// Adds the places where the netlist declares the stuck processes and channels. Also sorts the channels: first the
/// channels of the netlist, in its order, then channels that a program made.
void add_places(Deadlock&, const Network&);

} // namespace placedpar
