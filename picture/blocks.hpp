#pragma once

#include "picture/shapes.hpp"
#include "picture/wiring.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::picture {

/// Nodes that are drawn as one figure: an array, or single nodes that are wired into a line or a ring.
struct Block {
    std::vector<std::size_t> nodes;
    std::vector<Shape> shapes; ///< possible shapes, at least one; the best shape first
};

/// Divides the nodes into blocks; every node is in one block. The shapes of a block follow from subscripts and wires.
/// Two dimensions make a grid, one dimension makes a line, or a ring if it is closed. A hypercube makes a cube or a
/// torus; cube-connected cycles have cycles at the corners. Nodes that are all wired to one node make a circle around
/// it.
std::vector<Block> blocks_of(const Network&, const Wiring&);

} // namespace placedpar::picture
