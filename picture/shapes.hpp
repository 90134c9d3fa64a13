#pragma once

#include "picture/geometry.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar::picture {

/// The places of the nodes of a block, in cells of a grid. A block is a group of nodes that are drawn together. Each
/// node has its own cell.
using Shape = std::vector<Point>;

/// Stands for the parent of a tree's root.
inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// These functions return shapes, in the order of the nodes. Any two nodes of a shape are at least one cell apart,
// horizontally or vertically.

Shape row(std::size_t count);
Shape column(std::size_t count);
/// Makes rows of at most `longest` nodes. Every second row runs from right to left, so that successive nodes are
/// neighbours.
Shape snake(std::size_t count, std::size_t longest);
/// Makes about as many rows as columns; each row runs from left to right.
Shape rectangle(std::size_t count);
/// Makes a circle, clockwise from the top; four nodes make a square.
Shape circle(std::size_t count);
/// Returns whether all nodes have about the same distance from the centre.
bool is_circle(const Shape&);
/// Makes a circle that has room for a node in its centre.
Shape star(std::size_t count);
/// Makes a tree. Each node is below its parent, and each parent is above the middle of its children. `hangs_from` has
/// the parent of each node, and no_node for the root.
Shape tree(const std::vector<std::size_t>& hangs_from);
/// Places nodes by their subscripts: the last subscript counts across, the second last down, the third last across
/// again.
Shape grid(const std::vector<std::vector<std::int64_t>>& subscripts);
/// Makes a hypercube: with three dimensions a cube in perspective, otherwise a grid whose rows and columns are in the
/// order of the Gray code.
Shape hypercube(std::size_t dimensions);
/// Makes a hypercube in which each corner is a circle of `dimensions` nodes. Nodes of the same corner follow each other
/// in the order of the nodes. REQUIRES: three dimensions or more.
Shape cube_connected_cycles(std::size_t dimensions);

} // namespace placedpar::picture
