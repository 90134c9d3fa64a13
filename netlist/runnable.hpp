#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

namespace placedpar {

/// A network that can be shown need not be one that can be run: programs may be unknown, and channels lead to edges
/// that have no process. Throws RefusedInput with one message that names all of them.
void require_runnable(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
