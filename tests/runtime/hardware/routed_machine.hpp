#pragma once

#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::test {

/// A graph of processors and links.
struct Graph {
    std::size_t nodes;
    std::vector<std::pair<std::size_t, std::size_t>> links;
};

inline Graph ring(std::size_t n) {
    Graph graph{n, {}};
    for (std::size_t i = 0; i < n; ++i)
        graph.links.emplace_back(i, (i + 1) % n);
    return graph;
}

inline Graph torus(std::size_t rows, std::size_t columns) {
    Graph graph{rows * columns, {}};
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c) {
            graph.links.emplace_back(r * columns + c, r * columns + (c + 1) % columns);
            graph.links.emplace_back(r * columns + c, (r + 1) % rows * columns + c);
        }
    return graph;
}

inline Graph hypercube(std::size_t dimensions) {
    Graph graph{std::size_t{1} << dimensions, {}};
    for (std::size_t i = 0; i < graph.nodes; ++i)
        for (std::size_t d = 0; d < dimensions; ++d)
            if ((i & (std::size_t{1} << d)) == 0)
                graph.links.emplace_back(i, i | std::size_t{1} << d);
    return graph;
}

inline Graph line(std::size_t n) {
    Graph graph = ring(n);
    graph.links.pop_back();
    return graph;
}

/// A simulation of a graph, with a router on every processor.
class RoutedMachine {
public:
    explicit RoutedMachine(const Graph& graph, const hardware::RouterCosts& costs = {}) : graph_(graph) {
        for (std::size_t i = 0; i < graph.nodes; ++i) {
            processors.push_back(&simulation.add<hardware::Processor>("t" + std::to_string(i)));
            routers.push_back(&simulation.add<hardware::Router>(processors.back(), costs));
        }
        for (auto [a, b] : graph.links) {
            links.push_back(&simulation.add<hardware::Link>());
            shared.push_back(&simulation.add<hardware::RouterLink>(*links.back(), *routers[a], *routers[b]));
        }
    }

    /// Adds a route along the given processors. Each is a neighbour of the previous one.
    hardware::Route& route(const std::vector<std::size_t>& way) {
        std::vector<hardware::Hop> hops;
        for (std::size_t i = 0; i + 1 < way.size(); ++i)
            hops.push_back(hop(way[i], way[i + 1]));
        return simulation.add<hardware::Route>(hops);
    }

    /// Returns a random path that visits no processor twice. It need not be the shortest.
    std::vector<std::size_t> random_way(std::size_t from, std::size_t to, RandomStream& random) const {
        std::vector<std::size_t> way;
        do {
            way = {from};
            while (way.back() != to) {
                auto next = neighbours_not_on(way);
                if (next.empty())
                    break;
                way.push_back(next[random.below(static_cast<std::uint32_t>(next.size()))]);
            }
        } while (way.back() != to);
        return way;
    }

    /// Returns a path over the smallest number of links.
    std::vector<std::size_t> shortest_way(std::size_t from, std::size_t to) const {
        std::vector<std::vector<std::size_t>> next(graph_.nodes);
        for (auto [a, b] : graph_.links) {
            next[a].push_back(b);
            next[b].push_back(a);
        }
        std::vector<std::size_t> on_the_way(graph_.nodes, graph_.nodes), reached{to}; // next node of each node
        on_the_way[to] = to;
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (std::size_t node : next[reached[i]])
                if (on_the_way[node] == graph_.nodes) {
                    on_the_way[node] = reached[i];
                    reached.push_back(node);
                }
        std::vector<std::size_t> way{from};
        while (way.back() != to)
            way.push_back(on_the_way[way.back()]);
        return way;
    }

    Simulation simulation;
    std::vector<hardware::Processor*> processors;
    std::vector<hardware::Router*> routers;
    std::vector<hardware::Link*> links;
    std::vector<hardware::RouterLink*> shared; ///< the routers' part of each link

private:
    hardware::Hop hop(std::size_t from, std::size_t to) const {
        for (std::size_t i = 0; i < graph_.links.size(); ++i)
            for (bool forth : {true, false})
                if (graph_.links[i] == (forth ? std::pair(from, to) : std::pair(to, from)))
                    return {*shared[i], forth};
        throw std::logic_error("no neighbours");
    }

    std::vector<std::size_t> neighbours_not_on(const std::vector<std::size_t>& way) const {
        std::vector<std::size_t> found;
        for (auto [a, b] : graph_.links)
            for (auto [from, to] : {std::pair(a, b), std::pair(b, a)})
                if (from == way.back() && std::ranges::find(way, to) == way.end())
                    found.push_back(to);
        return found;
    }

    Graph graph_;
};

} // namespace placedpar::test
