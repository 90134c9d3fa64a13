// Tests on which thread or rank the processes of each node are placed.

#include "native/placement.hpp"

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/read.hpp"
#include "tests/seeds.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::native;

namespace {

using Loads = std::vector<Time>;
using Placed = std::vector<std::size_t>;

Loads loads_of(const std::vector<int>& numbers) { return Loads(numbers.begin(), numbers.end(), {}); }

/// A ring of nodes with a process each. `ranks` has the rank that each node states, -1 for none.
Network ring_with(const std::vector<int>& ranks) {
    std::string text;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        const std::string rank = ranks[i] < 0 ? "" : fmt::format(", rank = {}", ranks[i]);
        text += fmt::format("T800 (memory = 1M{}) t{};\nprocess (interface (input in, output out)) p{};\n"
                            "use \"csp.identity\" for p{}; place p{} on t{};\n",
                            rank, i, i, i, i, i);
    }
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        const std::size_t next = (i + 1) % ranks.size();
        text += fmt::format("connect t{}.link[1] to t{}.link[0]; connect p{}.out to p{}.in;\n", i, next, i, next);
    }
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    ReadResult read = read_netlist_text(text, catalogue, {});
    REQUIRE_MESSAGE(read.network, render(read.diagnostics.front()));
    return *read.network;
}

Time longest(const Placed& placed, const Loads& loads, std::size_t places) {
    std::vector<Time> filled(places);
    for (std::size_t i = 0; i < placed.size(); ++i)
        filled[placed[i]] += loads[i];
    return *std::ranges::max_element(filled);
}

/// Returns the least time that any placement takes, by trying all.
Time shortest_of_all(const Loads& loads, std::size_t places) {
    Placed placed(loads.size());
    Time least = Time::max();
    std::function<void(std::size_t)> place = [&](std::size_t i) {
        if (i == loads.size())
            least = std::min(least, longest(placed, loads, places));
        else
            for (placed[i] = 0; placed[i] < places; ++placed[i])
                place(i + 1);
    };
    place(0);
    return least;
}

} // namespace

TEST_CASE("nodes are placed in turn, but for those that state a rank") {
    CHECK(place_nodes(ring_with({-1, -1, -1, -1, -1}), {2}) == Placed{0, 1, 0, 1, 0});
    CHECK(place_nodes(ring_with({-1, 2, -1, -1, 0}), {3}) == Placed{0, 2, 2, 0, 0});
}

TEST_CASE("nodes are placed by load, the heaviest first") {
    // Graham's example of the worst case: 11 instead of 9.
    const Loads worst = loads_of({5, 5, 4, 4, 3, 3, 3});
    const Placed placed = place_nodes(ring_with({-1, -1, -1, -1, -1, -1, -1}), {3}, worst);
    CHECK(placed == Placed{0, 1, 2, 2, 0, 1, 0});
    CHECK(longest(placed, worst, 3) == Time(11));
    CHECK(shortest_of_all(worst, 3) == Time(9));
    CHECK(place_nodes(ring_with({-1, -1, 0, -1}), {2}, loads_of({1, 2, 5, 2})) == Placed{1, 1, 0, 1});
}

TEST_CASE("nodes without any load are spread evenly") {
    CHECK(place_nodes(ring_with({-1, -1, -1, -1}), {2}, loads_of({0, 0, 0, 0})) == Placed{0, 1, 0, 1});
}

TEST_CASE("a placement by load keeps Graham's bound, and every rank") {
    for (const std::uint64_t seed : test::seeds(100)) {
        INFO(test::replay(seed));
        std::mt19937_64 random(seed);
        const std::size_t places = 2 + random() % 2, nodes = 3 + random() % 5;
        std::vector<int> none(nodes, -1), ranks(nodes, -1), numbers(nodes);
        for (std::size_t i = 0; i < nodes; ++i) {
            numbers[i] = static_cast<int>(random() % 20);
            if (random() % 3 == 0)
                ranks[i] = static_cast<int>(random() % places);
        }
        const Loads loads = loads_of(numbers);
        const Time takes = longest(place_nodes(ring_with(none), {places}, loads), loads, places);
        // 4/3 - 1/3m of the least time that is possible on m places
        const auto m = static_cast<std::int64_t>(places);
        CHECK(3 * m * takes <= (4 * m - 1) * shortest_of_all(loads, places));
        const Placed placed = place_nodes(ring_with(ranks), {places}, loads);
        for (std::size_t i = 0; i < nodes; ++i)
            if (ranks[i] >= 0)
                CHECK(placed[i] == static_cast<std::size_t>(ranks[i]));
    }
}

TEST_CASE("a rank above the number of threads is refused with its place in the netlist") {
    const Network network = ring_with({-1, 4, -1});
    CHECK(most_places(network) == 5);
    for (const Loads& loads : {Loads{}, loads_of({1, 1, 1})})
        CHECK_THROWS_WITH_AS(
            place_nodes(network, {4}, loads),
            doctest::Contains("netlist:4:30: \"t1\" has rank = 4, but the run has 4 threads, counted from 0: "
                              "give --threads 5 or more"),
            UserError);
    CHECK(place_nodes(network, {5}) == Placed{0, 4, 2});
}

TEST_CASE("no more threads are suggested than a run can have") {
    CHECK_THROWS_WITH_AS(place_nodes(ring_with({-1, 99999}), {2}),
                         doctest::Contains("2 threads, counted from 0: give a rank below 1024"), UserError);
    CHECK_THROWS_WITH_AS(place_nodes(ring_with({-1, 1023}), {2}), doctest::Contains("give --threads 1024 or more"),
                         UserError);
}

TEST_CASE("more ranks than processors with processes are refused with the number that is possible") {
    CHECK_NOTHROW(require_enough_nodes(ring_with({-1, -1}), 2));
    CHECK_THROWS_WITH_AS(require_enough_nodes(ring_with({-1, -1}), 3),
                         doctest::Contains("only 2 processors have processes: start at most 2 ranks"), UserError);
    Catalogue catalogue;
    const Network empty = *read_netlist_text("T800 t;", catalogue, {}).network;
    CHECK_THROWS_WITH_AS(
        require_enough_nodes(empty, 2),
        doctest::Contains(
            "no processor has a process, so 2 ranks have nothing to share: run the netlist without mpirun, "
            "or predict it without --ranks"),
        UserError);
}

TEST_CASE("the netlist's text keeps a rank, and simulations do not see it") {
    CHECK(ring_with({-1, 1, -1}).nodes[1].rank == 1);
    CHECK_FALSE(ring_with({-1, 1, -1}).nodes[0].rank);
    for (const char* wrong : {"-1", "1.5", "\"1\"", "1000000"}) {
        Catalogue catalogue;
        add_csp_kinds(catalogue);
        CHECK_FALSE(read_netlist_text(fmt::format("T800 (rank = {}) t;", wrong), catalogue, {}).network);
    }
}
