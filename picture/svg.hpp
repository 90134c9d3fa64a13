#pragma once

#include "netlist/network/network.hpp"

#include <string>

namespace placedpar {

/// Draws the network as SVG. The drawing has nodes, placed by their subscripts, with their processes; wires with link
/// numbers and channels; and a legend. The same network gives the same bytes.
std::string print_svg(const Network& network);

/// Draws the network's software as SVG: all processes, regardless of their nodes, and the channels between them. Each
/// channel is labelled with the name of the sender's port.
std::string print_software_svg(const Network& network);

} // namespace placedpar
