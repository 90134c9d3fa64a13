#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>

namespace placedpar::generate {

/// Of the processors of a network, which are what processes take time on, and the wires between them.
struct Distances {
    std::size_t processors = 0, links = 0;
    std::size_t degree = 0;   ///< the most links of one to others
    std::size_t diameter = 0; ///< the most wires between two of them by the shortest way
    bool connected = true;    ///< there is a way from each to each
};

Distances distances_in(const Network&);

} // namespace placedpar::generate
