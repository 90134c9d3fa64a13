#pragma once

#include "netlist/network/network.hpp"

#include <string>

namespace placedpar {

/// The network drawn as SVG: nodes where their subscripts put them, with their processes; wires with the numbers of
/// their links and the channels that they carry; a legend. The same network gives the same bytes.
std::string print_svg(const Network& network);

/// The network's software drawn likewise: processes, wherever they are placed, and the channels between them, each with
/// the name by which its sender knows it.
std::string print_software_svg(const Network& network);

} // namespace placedpar
