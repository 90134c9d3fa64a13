#pragma once

#include "picture/boxes.hpp"
#include "picture/routes.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// Networks of at least this many nodes are drawn by draw_large().
inline constexpr std::size_t large_network = 200;

/// Draws a large network of n nodes in O(n log n) time. Every array of nodes has the best shape for its subscripts and
/// wires, such as a grid or a ring (blocks.hpp). Single nodes are to the left of the largest block. Wires between
/// neighbours are straight; other wires lead between rows and columns or inside a ring, and not through boxes. Wires
/// have no labels.
std::pair<std::vector<DrawnNode>, std::vector<DrawnWire>> draw_large(const Network&, const std::vector<Span>&);

} // namespace placedpar::picture
