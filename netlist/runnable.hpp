#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

namespace placedpar {

/// Checks that a network can be run. A network that can only be shown may have unknown programs, or channels to edges
/// without a process. For such a network, throws RefusedInput with one message that names all these programs and
/// channels.
void require_runnable(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
