#pragma once

#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <vector>

namespace placedpar::picture {

/// Returns the place of each node, in cells. Any two nodes are at least one cell apart, horizontally or vertically.
/// Blocks (blocks.hpp) are placed one after the other: first the block with the most nodes, then always the block with
/// the most wires to placed blocks. Each block is placed so that these wires are short and, if possible, cross nothing.
std::vector<Point> arrange(const Network&, const Wiring&);

} // namespace placedpar::picture
