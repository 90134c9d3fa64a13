#pragma once

#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <vector>

namespace placedpar::picture {

/// Where each node stands, in cells: no two are less than one apart both across and down. Blocks (blocks.hpp) are put
/// down one after the other, from the largest on, each where its wires to those before it are short and cross nothing.
std::vector<Point> arrange(const Network&, const Wiring&);

} // namespace placedpar::picture
