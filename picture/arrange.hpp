#pragma once

#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <vector>

namespace placedpar::picture {

/// Returns the place of each node, in cells. Any two nodes are at least one cell apart across or down. Blocks
/// (blocks.hpp) are placed one after the other, the largest first. Each is placed so that its wires to the blocks
/// already placed are short and cross nothing.
std::vector<Point> arrange(const Network&, const Wiring&);

} // namespace placedpar::picture
