#pragma once

#include "netlist/network/network.hpp"
#include "workbench/picture/boxes.hpp"
#include "workbench/picture/routes.hpp"

#include <vector>

namespace placedpar::picture {

/// Where everything stands in the drawing of a network, in pixels.
struct Picture {
    std::vector<DrawnNode> nodes; ///< in the order of the network's
    std::vector<DrawnWire> wires; ///< in the order of the network's connections
};

/// The same network gives the same picture. No two boxes or labels overlap.
Picture draw(const Network&);

/// What all of it takes. REQUIRES: there is a node.
Box extent_of(const Picture&);

} // namespace placedpar::picture
