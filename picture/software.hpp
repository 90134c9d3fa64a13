#pragma once

#include "netlist/network/network.hpp"
#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <vector>

namespace placedpar::picture {

/// A network's software in the form of a network, so that it is drawn as one: a node for each process, and for each
/// edge that channels lead to; a wire between two of them for all channels that lead from one to the other and back.
struct Software {
    Network network;
    std::vector<Span> spans;   ///< at each end the ports that send from there
    std::vector<Point> places; ///< of its nodes, in cells, where they form a tree that branches; else none
};

Software software_of(const Network&);

} // namespace placedpar::picture
