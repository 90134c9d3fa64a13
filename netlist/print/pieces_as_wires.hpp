#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// Returns the network as it is drawn. The connections that switches can make during the run are removed. In their
/// place are the wires that lead to these switches. The route of a channel over such a connection then consists of the
/// wires from both ends to the switches.
Network with_pieces_as_wires(Network network);

} // namespace placedpar
