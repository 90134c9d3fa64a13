#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// Returns the network as it is drawn: the connections that switches can make during the run are replaced by the pieces
/// of wire that lead to these switches. The route of a channel over such a connection then
/// consists of these pieces.
Network with_pieces_as_wires(Network network);

} // namespace placedpar
