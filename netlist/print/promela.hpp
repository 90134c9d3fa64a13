#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <string>

namespace placedpar {

/// The network as a model for Spin: a proctype for each process, a rendezvous channel for each channel. It knows
/// neither time nor placement, so that what Spin finds impossible no machine can do; what it finds possible, some
/// machine may do. A process that never ends its statements is an invalid end state, as it is waiting in PlacedPar's
/// reports. Throws UserError: a process whose kind does not say what it does in Promela, or more of them than Spin
/// has room for.
std::string print_promela(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
