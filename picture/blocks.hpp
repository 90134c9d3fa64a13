#pragma once

#include "picture/shapes.hpp"
#include "picture/wiring.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::picture {

/// Nodes that are drawn as one figure: an array, or single nodes that are wired into a line, a ring or a tree.
struct Block {
    std::vector<std::size_t> nodes;
    std::vector<Shape> shapes; ///< possible places of the nodes relative to each other, at least one; the best first
};

/// Divides the nodes into blocks. Each node is in one block. Subscripts and wires determine the shapes of a block. Two
/// dimensions make a grid; one dimension makes a line, or a ring if a wire joins its ends. A hypercube of three
/// dimensions is drawn as a cube, any other hypercube as a grid. Cube-connected cycles are drawn as a hypercube with a
/// circle of nodes at each corner. Nodes that are all wired to one other node make a circle around that node.
std::vector<Block> blocks_of(const Network&, const Wiring&);

} // namespace placedpar::picture
