#pragma once

#include "picture/geometry.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar::picture {

/// Where the nodes of a block can stand, each relative to the block, in cells: a node takes a cell of its own.
using Shape = std::vector<Point>;

/// The node that a tree's root hangs from.
inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// Figures that nodes can stand in, in the order of the nodes. In each, any two nodes are a cell apart across or down.

Shape row(std::size_t count);
Shape column(std::size_t count);
/// Rows of at most so many, every second one from right to left: neighbours stay neighbours.
Shape snake(std::size_t count, std::size_t longest);
/// Rows of about as many as there are rows, each from left to right.
Shape rectangle(std::size_t count);
/// Clockwise from the top; four of them are a square.
Shape circle(std::size_t count);
/// Whether all stand about as far from the middle.
bool is_circle(const Shape&);
/// Makes a circle with room for a node in the centre.
Shape star(std::size_t count);
/// Each node below the one that it hangs from, which stands above the middle of all that hang from it. The
/// root hangs from no_node.
Shape tree(const std::vector<std::size_t>& hangs_from);
/// By subscripts: the last goes across, the one before it down, the one before that across again.
Shape grid(const std::vector<std::vector<std::int64_t>>& subscripts);
/// Of a hypercube: three dimensions as a cube is drawn, more as a torus, in the order of Gray's code.
Shape hypercube(std::size_t dimensions);
/// The same with a circle of as many nodes as dimensions in the place of each corner, corner by corner. REQUIRES: three
/// dimensions or more.
Shape cube_connected_cycles(std::size_t dimensions);

} // namespace placedpar::picture
