#pragma once

#include "picture/shapes.hpp"
#include "picture/wiring.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::picture {

/// Nodes that are drawn as one figure: an array, or single nodes that are wired into a line or a ring.
struct Block {
    std::vector<std::size_t> nodes;
    std::vector<Shape> shapes; ///< at least one, the best first
};

/// Every node is in one block. Subscripts and wires give a block its shapes: two dimensions make a grid, one a line, a
/// ring where it closes, a cube or a torus where it is a hypercube, with cycles at the corners where those are
/// cube-connected, a circle around the node that all are wired to.
std::vector<Block> blocks_of(const Network&, const Wiring&);

} // namespace placedpar::picture
