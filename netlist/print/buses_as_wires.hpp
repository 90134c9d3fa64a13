#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// Returns the network as it is drawn: the ways over a bus are replaced by a line from each device to the bus, and a
/// channel over a way takes the two lines between its devices and the bus. A line has no speed (bits_per_second is 0).
/// At the line's end b, the bus, the link number is the slot; its end a has no link number.
Network with_buses_as_wires(Network network);

} // namespace placedpar
