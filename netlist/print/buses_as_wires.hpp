#pragma once

#include "netlist/network/network.hpp"

namespace placedpar {

/// The network as it is drawn: a line from each device on a bus to the bus takes the place of the ways over it, and
/// channels that go over a way go over its lines. Such a line has no speed: its bits_per_second is 0; at its end b, the
/// bus, its link is a slot, and its end a has none.
Network with_buses_as_wires(Network network);

} // namespace placedpar
