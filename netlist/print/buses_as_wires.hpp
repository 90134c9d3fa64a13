#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// Returns the network as it is drawn: the ways over a bus are replaced by a line from each device to the bus. A
/// channel over a way takes the lines of the two devices at its ends. A line has no speed (bits_per_second is 0). End b
/// of a line is the bus, with the slot as its link number; end a has no link number.
Network with_buses_as_wires(Network network);

} // namespace placedpar
