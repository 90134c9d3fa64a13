#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

namespace placedpar {

/// Throws RefusedInput if a network can be shown, but not run: a program is unknown, or a channel leads to an edge
/// without a process. One message lists all these programs and edges.
void require_runnable(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
