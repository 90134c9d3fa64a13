#include "explore/generate/distances.hpp"

#include "netlist/kinds/device_kind.hpp"

#include <algorithm>
#include <vector>

namespace placedpar::generate {

namespace {

using Neighbours = std::vector<std::vector<std::size_t>>;

bool is_processor(const Node& node) { return node.attributes.contains("channelcall") && node.kind->has_executive(); }

Neighbours neighbours_in(const Network& network) {
    Neighbours neighbours(network.nodes.size());
    for (const LinkConnection& wire : network.connections)
        if (is_processor(network.nodes[wire.a.node]) && is_processor(network.nodes[wire.b.node])) {
            neighbours[wire.a.node].push_back(wire.b.node);
            neighbours[wire.b.node].push_back(wire.a.node);
        }
    return neighbours;
}

struct Reached {
    std::size_t nodes = 0, farthest = 0;
};

Reached reached_from(std::size_t start, const Neighbours& neighbours) {
    std::vector<std::size_t> distance(neighbours.size(), nowhere), queue{start};
    distance[start] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (std::size_t other : neighbours[queue[next]])
            if (distance[other] == nowhere) {
                distance[other] = distance[queue[next]] + 1;
                queue.push_back(other);
            }
    return {queue.size(), distance[queue.back()]};
}

} // namespace

Distances distances_in(const Network& network) {
    Neighbours neighbours = neighbours_in(network);
    Distances found;
    found.processors = static_cast<std::size_t>(std::ranges::count_if(network.nodes, is_processor));
    for (std::size_t node = 0; node < network.nodes.size(); ++node)
        if (is_processor(network.nodes[node])) {
            Reached reached = reached_from(node, neighbours);
            found.links += neighbours[node].size(); // each link is counted at both ends
            found.degree = std::max(found.degree, neighbours[node].size());
            found.diameter = std::max(found.diameter, reached.farthest);
            found.connected = found.connected && reached.nodes == found.processors;
        }
    found.links /= 2;
    return found;
}

} // namespace placedpar::generate
