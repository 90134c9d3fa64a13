#pragma once

#include "netlist/network/network.hpp"
#include "picture/boxes.hpp"
#include "picture/routes.hpp"

#include <vector>

namespace placedpar::picture {

/// The places of everything in the drawing of a network, in pixels.
struct Picture {
    std::vector<DrawnNode> nodes; ///< in the order of the network's nodes
    std::vector<DrawnWire> wires; ///< in the order of the network's connections
};

/// Draws a network; the same network gives the same picture. No two boxes or labels overlap. `spans`: the parts of the
/// network's wires between devices, from spans_of() (wiring.hpp). `places` has the places of the nodes, in cells; if
/// `places` is empty, or the network is large (large.hpp), draw() arranges the nodes.
Picture draw(const Network&, const std::vector<Span>&, const std::vector<Point>& places = {});

/// Returns the box that contains the whole picture. REQUIRES: there is a node.
Box extent_of(const Picture&);

} // namespace placedpar::picture
