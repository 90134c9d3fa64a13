#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// The network as it is drawn: the pieces of wire that lead to switches which are set during the run take the place of
/// the connections that these switches can make, and a channel over such a connection goes over its pieces.
Network with_pieces_as_wires(Network network);

} // namespace placedpar
