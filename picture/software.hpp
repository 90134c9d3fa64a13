#pragma once

#include "netlist/network/network.hpp"
#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <vector>

namespace placedpar::picture {

/// A network's processes and channels in the form of another network, which the functions for machines can draw. It has
/// a node for each process, and for each edge of the network with channels. One wire between two nodes stands for all
/// channels between them, in both directions.
struct Software {
    Network network;
    std::vector<Span> spans;   ///< labelled at each end with the output ports of that end
    std::vector<Point> places; ///< places of the nodes, in cells, if they form a tree with branches; else empty
};

Software software_of(const Network&);

} // namespace placedpar::picture
