// Tests that routes are the best routes if many routes begin at the same processor.

#include "netlist/complete/routes.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <random>
#include <string>

using namespace placedpar;

namespace {

constexpr std::size_t side = 7;

/// A torus of processors with different route costs. With quotas, one processor in ten does not route through one of
/// its links.
Network torus_of(std::mt19937_64& random, bool with_quotas) {
    std::string text;
    for (std::size_t i = 0; i < side * side; ++i)
        text += fmt::format("T800 (memory = 1M, routecost = {}{}) t{};\n", random() % 3,
                            with_quotas && random() % 10 == 0 ? ", linkquota = 3" : "", i);
    for (std::size_t i = 0; i < side * side; ++i) {
        const std::size_t right = i / side * side + (i + 1) % side, below = (i + side) % (side * side);
        text += fmt::format("connect t{0}.link[0] to t{1}.link[1]; connect t{0}.link[2] to t{2}.link[3];\n", i, right,
                            below);
    }
    return *read_netlist_text(text, small_catalogue()).network;
}

} // namespace

TEST_CASE("one search object finds the same routes as a new search for each route") {
    for (std::uint64_t seed : test::seeds(6)) {
        INFO(test::replay(seed));
        std::mt19937_64 random(seed);
        const Network network = torus_of(random, seed % 3 == 0);
        std::vector<std::size_t> load(2 * network.connections.size());
        const std::vector<bool> all(network.nodes.size(), true);
        RouteSearch search(network.nodes, network.connections, load, all);
        for (int i = 0; i < 150; ++i) {
            const std::size_t host = random() % 2, other = 2 + random() % (side * side - 2);
            const bool out = random() % 2 == 0;
            const std::size_t from = out ? host : other, to = out ? other : host;
            auto route = search.best(from, to);
            auto alone = RouteSearch(network.nodes, network.connections, load, all).best(from, to);
            REQUIRE(route.has_value());
            REQUIRE(*route == *alone);
            for (const RouteHop& hop : *route)
                ++load[2 * hop.connection + (hop.from_a_to_b ? 1 : 0)];
        }
    }
}
