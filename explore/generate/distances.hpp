#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>

namespace placedpar::generate {

/// Describes the graph of a network, whose nodes are the processors and whose edges are the wires between them.
struct Distances {
    std::size_t processors = 0, links = 0;
    std::size_t degree = 0; ///< largest number of links from one processor to other processors
    /// Number of wires on the shortest path between the two processors farthest from each other.
    std::size_t diameter = 0;
    bool connected = true; ///< whether every processor can reach every other processor
};

Distances distances_in(const Network&);

} // namespace placedpar::generate
