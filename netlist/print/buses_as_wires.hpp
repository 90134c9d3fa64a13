#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// Returns the network as it is drawn. In place of the ways over a bus, which are paths from a master to a slave, there
/// is one connection from each device to the bus: a line. The route of a channel over a way then consists of the lines
/// of the two devices at the ends of the way. A line has no speed (bits_per_second is 0). End b of a line is the bus,
/// with the slot as its link number; end a has no link number.
Network with_buses_as_wires(Network network);

} // namespace placedpar
