#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>

namespace placedpar::generate {

/// Describes the graph of the processors of a network and the wires between them.
struct Distances {
    std::size_t processors = 0, links = 0;
    std::size_t degree = 0;   ///< largest number of links from one processor to other processors
    std::size_t diameter = 0; ///< largest number of wires on a shortest path
    bool connected = true;    ///< every processor can reach every other processor
};

Distances distances_in(const Network&);

} // namespace placedpar::generate
