#include "gaprocs/policies/topology.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace placedpar;

namespace {

using IslandNumbers = std::vector<std::size_t>;

Neighbours neighbours_in(const char* topology, std::size_t islands) {
    return Topology::named(topology).neighbours(islands);
}

bool is_edge(const Neighbours& neighbours, std::size_t from, std::size_t to) {
    return std::count(neighbours[from].begin(), neighbours[from].end(), to) == 1;
}

/// Returns the greatest distance of two islands. Throws std::bad_optional_access if one never reaches another.
std::size_t diameter(const Neighbours& neighbours) {
    std::size_t greatest = 0;
    for (std::size_t from = 0; from < neighbours.size(); ++from)
        for (auto distance : distances(neighbours, from))
            greatest = std::max(greatest, distance.value());
    return greatest;
}

void check_degrees(const Neighbours& neighbours, std::size_t degree) {
    for (const auto& list : neighbours)
        CHECK(list.size() == degree);
}

void check_edges_both_ways(const Neighbours& neighbours) {
    for (std::size_t from = 0; from < neighbours.size(); ++from)
        for (std::size_t to : neighbours[from]) {
            CHECK(to != from);
            CHECK(is_edge(neighbours, from, to));
            CHECK(is_edge(neighbours, to, from));
        }
}

std::string refusal(const Topology& topology, std::size_t islands) {
    try {
        topology.neighbours(islands);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("a ring connects each island to the next, and with two ways also to the one before") {
    CHECK(neighbours_in("ring", 4) == Neighbours{{1}, {2}, {3}, {0}});
    CHECK(neighbours_in("ring(ways = 2)", 4) == Neighbours{{1, 3}, {2, 0}, {3, 1}, {0, 2}});
    CHECK(neighbours_in("ring(2)", 2) == Neighbours{{1}, {0}});
    for (std::size_t n : {2u, 3u, 8u, 13u}) {
        CHECK(diameter(neighbours_in("ring", n)) == n - 1);
        CHECK(diameter(neighbours_in("ring(2)", n)) == n / 2);
        check_edges_both_ways(neighbours_in("ring(2)", n));
    }
}

TEST_CASE("a hypercube connects islands whose numbers differ in one binary digit") {
    CHECK(neighbours_in("hypercube", 4) == Neighbours{{1, 2}, {0, 3}, {3, 0}, {2, 1}});
    for (std::size_t dimensions : {1u, 2u, 3u, 6u}) {
        auto cube = neighbours_in("hypercube", std::size_t{1} << dimensions);
        check_degrees(cube, dimensions);
        check_edges_both_ways(cube);
        CHECK(diameter(cube) == dimensions);
    }
    CHECK(distances(neighbours_in("hypercube", 8), 5)[2] == 3u);
    CHECK(distances(neighbours_in("hypercube", 8), 5)[4] == 1u);
}

TEST_CASE("a torus connects each island to the east, south, west and north") {
    // The islands are numbered as follows:
    //     0 1 2 3
    //     4 5 6 7
    //     8 9 10 11
    auto torus = neighbours_in("torus(3)", 12);
    CHECK(torus[5] == IslandNumbers{6, 9, 4, 1});
    CHECK(torus[11] == IslandNumbers{8, 3, 10, 7});
    check_degrees(torus, 4);
    check_edges_both_ways(torus);
    CHECK(diameter(torus) == 1 + 2);
    CHECK(neighbours_in("torus(2)", 4) == Neighbours{{1, 2}, {0, 3}, {3, 0}, {2, 1}}); // each neighbour occurs once
    CHECK(neighbours_in("torus(1)", 5) == neighbours_in("ring(2)", 5));
    check_edges_both_ways(neighbours_in("torus(2)", 10));
}

TEST_CASE("a star connects island 0 with all others, and the farthest island is two exchanges away") {
    auto star = neighbours_in("star", 5);
    CHECK(star == Neighbours{{1, 2, 3, 4}, {0}, {0}, {0}, {0}});
    check_edges_both_ways(star);
    CHECK(diameter(star) == 2);
}

TEST_CASE("a complete topology connects each island each island sends to all others, beginning with the next") {
    auto complete = neighbours_in("complete", 5);
    CHECK(complete[3] == IslandNumbers{4, 0, 1, 2});
    check_degrees(complete, 4);
    check_edges_both_ways(complete);
    CHECK(diameter(complete) == 1);
}

TEST_CASE("if every island sends to its n-th neighbour, each receives from one island") {
    for (const char* topology : {"ring(2)", "hypercube", "torus(4)", "torus(2)", "complete"}) {
        CAPTURE(topology);
        auto neighbours = neighbours_in(topology, 16);
        for (std::size_t place = 0; place < neighbours.front().size(); ++place) {
            std::vector<std::size_t> receivers;
            for (const auto& list : neighbours)
                receivers.push_back(list.at(place));
            std::sort(receivers.begin(), receivers.end());
            for (std::size_t i = 0; i < receivers.size(); ++i)
                CHECK(receivers[i] == i);
        }
    }
}

TEST_CASE("in the topology \"none\", islands have no neighbours, and there may be a single island") {
    CHECK(neighbours_in("none", 3) == Neighbours(3));
    CHECK(neighbours_in("none", 1) == Neighbours(1));
    CHECK_FALSE(distances(neighbours_in("none", 2), 0)[1].has_value());
}

TEST_CASE("one_way finds an island whose individuals never reach another island of its part") {
    auto lost = one_way({{1}, {2}, {}}); // a chain
    REQUIRE(lost);
    CHECK(lost->from == 1);
    CHECK(lost->never_to == 0);
    lost = one_way({{1, 2}, {0}, {}}); // island 0 sends to all others, island 2 to none
    REQUIRE(lost);
    CHECK(lost->from == 2);
    CHECK(lost->never_to == 0);
    lost = one_way({{1}, {0}, {3}, {2, 4}, {}}); // the one-way connection is in the second part
    REQUIRE(lost);
    CHECK(lost->from == 4);
    CHECK(lost->never_to == 2);
    CHECK_FALSE(one_way({{1}, {0}, {}})); // island 2 is isolated
    for (const char* topology : {"ring", "torus(2)", "hypercube", "star", "complete"})
        CHECK_FALSE(one_way(neighbours_in(topology, 8)));
}

TEST_CASE("separate_parts finds the parts that do not exchange with each other") {
    for (const char* topology : {"ring", "ring(2)", "hypercube", "torus(4)", "star", "complete"})
        CHECK(separate_parts(neighbours_in(topology, 8)).size() == 1);
    CHECK(separate_parts(neighbours_in("none", 3)) == Neighbours{{0}, {1}, {2}});
    CHECK(separate_parts({{2}, {3}, {0}, {1}}) == Neighbours{{0, 2}, {1, 3}});
    CHECK(separate_parts({{}, {0}, {1}}) == Neighbours{{0, 1, 2}}); // one direction is enough
}

TEST_CASE("given neighbours may be one-way, and a list that does not fit is refused") {
    Neighbours given{{2, 1}, {}, {0}};
    CHECK(Topology(GivenTopology{given}).neighbours(3) == given);
    CHECK(refusal(GivenTopology{given}, 4) ==
          "the list has the neighbours of 3 islands, but the number of islands is 4");
    CHECK(refusal(GivenTopology{{{1}, {2}}}, 2) == "island 1 has island 2 as neighbour, expected 0 to 1");
    CHECK(refusal(GivenTopology{{{1}, {0, 1}}}, 2) == "island 1 is its own neighbour, expected another island");
    CHECK(refusal(GivenTopology{{{1, 1}, {0}}}, 2) == "island 0 has island 1 as neighbour twice, expected once");
    CHECK(refusal(GivenTopology{{{1}, {0}, {}}}, 3) ==
          "island 2 of 3 has no neighbours, expected at least one, or the topology \"none\" for islands that exchange "
          "nothing");
    CHECK(refusal(Topology::named("given"), 2) ==
          "the list has the neighbours of 0 islands, but the number of islands is 2");
}

TEST_CASE("a number of islands that does not fit the topology is refused with the numbers that fit") {
    CHECK(refusal(HypercubeTopology{}, 12) ==
          "a hypercube cannot have 12 islands, expected a power of two such as 8 or 16");
    CHECK(refusal(TorusTopology{3}, 10) ==
          "a torus of 10 islands cannot have 3 rows, expected a divisor of 10: 1, 2, 5, 10");
    for (const PolicyDescription& way : Topology::descriptions())
        CHECK(refusal(Topology::named(way.name), 0) == "the number of islands is 0, expected at least 1");
    for (const char* topology : {"ring", "hypercube", "torus(1)", "star", "complete"})
        CHECK(refusal(Topology::named(topology), 1).starts_with("island 0 of 1 has no neighbours"));
}

TEST_CASE("topologies are named by their text") {
    CHECK(Topology().text() == "ring(ways = 1)");
    CHECK(Topology::named("torus(4)").text() == "torus(rows = 4)");
    for (const PolicyDescription& way : Topology::descriptions())
        CHECK(Topology::named(way.text()).text() == way.text());
}

TEST_CASE("the refusal of a torus of one island has a singular noun") {
    CHECK_THROWS_WITH_AS(Topology::named("torus(2)").neighbours(1),
                         "a torus of 1 island cannot have 2 rows, expected a divisor of 1: 1", UserError);
}
