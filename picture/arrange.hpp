#pragma once

#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <vector>

namespace placedpar::picture {

/// Returns where to draw each node of the network, in cells of a grid. Any two nodes are at least one cell apart,
/// horizontally or vertically. Blocks, that is, groups of nodes that are drawn together (blocks.hpp), are placed one
/// after the other: first the block with the most nodes, then always the block with the most wires to placed blocks.
/// Each block is placed so that these wires are short and, if possible, cross nothing.
std::vector<Point> arrange(const Network&, const Wiring&);

} // namespace placedpar::picture
