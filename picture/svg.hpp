#pragma once

#include "netlist/network/network.hpp"

#include <string>

namespace placedpar {

/// Draws the network as SVG: nodes, placed by their subscripts, with their processes; wires with link numbers and
/// channels; a legend. The same network gives the same bytes.
std::string print_svg(const Network& network);

/// Draws the network's software as SVG: processes, whatever node they are placed on, and the channels between them,
/// each with the sender's name for it.
std::string print_software_svg(const Network& network);

} // namespace placedpar
