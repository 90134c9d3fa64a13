#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

namespace placedpar {

/// Throws RefusedInput if a network can be drawn, but not run. Either no program of the catalogue has the name that a
/// process states, or a channel leads to an edge, that is, out of the network, without a process there. One message
/// lists all these programs and edges.
void require_runnable(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
