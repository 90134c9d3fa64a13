#pragma once

#include "picture/boxes.hpp"
#include "picture/routes.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// From so many nodes on a network is drawn as this file says.
inline constexpr std::size_t large_network = 200;

/// The picture of a large network, in a time of n log n. Every array stands as its block says (blocks.hpp), single
/// nodes stand at the left, and the one that most of a ring is wired to in its centre. Wires between neighbours are
/// straight; others lead between the rows and columns, or inside of a ring, and through no box. Nothing is written on
/// them.
std::pair<std::vector<DrawnNode>, std::vector<DrawnWire>> draw_large(const Network&, const std::vector<Span>&);

} // namespace placedpar::picture
