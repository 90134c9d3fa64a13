#pragma once

#include "netlist/network/network.hpp"
#include "picture/boxes.hpp"
#include "picture/routes.hpp"

#include <vector>

namespace placedpar::picture {

/// Where everything stands in the drawing of a network, in pixels.
struct Picture {
    std::vector<DrawnNode> nodes; ///< in the order of the network's
    std::vector<DrawnWire> wires; ///< in the order of the network's connections
};

/// The same network gives the same picture. No two boxes or labels overlap. The spans are those of its wires.
/// Without places for its nodes, in cells, they are arranged; those of a large network always are (large.hpp).
Picture draw(const Network&, const std::vector<Span>&, const std::vector<Point>& places = {});

/// What all of it takes. REQUIRES: there is a node.
Box extent_of(const Picture&);

} // namespace placedpar::picture
