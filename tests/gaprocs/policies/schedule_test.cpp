#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

using namespace placedpar;

namespace {

using IslandNumbers = std::vector<std::size_t>;

IslandNumbers destinations(const char* schedule, std::uint64_t generation, const IslandNumbers& neighbours) {
    auto found = Schedule::named(schedule).destinations(generation, neighbours);
    return {found.begin(), found.end()};
}

} // namespace

TEST_CASE("a broadcast goes to all neighbours every n generations, first after generation n") {
    IslandNumbers neighbours{7, 2, 5};
    for (std::uint64_t generation = 0; generation <= 12; ++generation) {
        bool due = generation == 4 || generation == 8 || generation == 12;
        CHECK(destinations("broadcast(4)", generation, neighbours) == (due ? neighbours : IslandNumbers{}));
    }
    CHECK(destinations("broadcast(1)", 1, neighbours) == neighbours);
    CHECK(destinations("broadcast", 3, {}).empty());
}

TEST_CASE("a sequential exchange goes to one neighbour after another, then again to the first") {
    IslandNumbers visited;
    for (std::uint64_t generation = 0; generation <= 14; ++generation)
        for (std::size_t to : destinations("sequential(2)", generation, {7, 2, 5})) {
            CHECK(generation % 2 == 0);
            visited.push_back(to);
        }
    CHECK(visited == IslandNumbers{7, 2, 5, 7, 2, 5, 7});
    CHECK(destinations("sequential", 3, {}).empty());
}

TEST_CASE("a sequential exchange on a hypercube of two dimensions alternates between i xor 1 and i xor 2") {
    auto square = Topology::named("hypercube").neighbours(4);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::uint64_t exchange = 1; exchange <= 6; ++exchange)
            CHECK(destinations("sequential(every = 5)", 5 * exchange, square[i]) ==
                  IslandNumbers{i ^ (exchange % 2 == 1 ? 1u : 2u)});
}

TEST_CASE("asynchronous exchange goes to all neighbours as a broadcast does, but not in step") {
    IslandNumbers neighbours{7, 2, 5};
    CHECK(destinations("asynchronous(4)", 8, neighbours) == neighbours);
    CHECK(destinations("asynchronous(4)", 9, neighbours).empty());
    CHECK_FALSE(Schedule::named("asynchronous").in_step());
    CHECK(Schedule::named("sequential").in_step());
    CHECK(Schedule::named("asynchronous(7)").every() == 7);
}

TEST_CASE("most_senders_at_once counts the islands whose emigrants can come at once") {
    auto most = [](const char* schedule, const Neighbours& neighbours) {
        return most_senders_at_once(Schedule::named(schedule), neighbours);
    };
    Neighbours star = Topology::named("star").neighbours(5), complete = Topology::named("complete").neighbours(5);
    CHECK(most("broadcast", star) == IslandNumbers{4, 1, 1, 1, 1});
    CHECK(most("sequential", star) == IslandNumbers{4, 1, 1, 1, 1});
    CHECK(most("asynchronous", complete) == IslandNumbers{4, 4, 4, 4, 4});
    CHECK(most("sequential", complete) == IslandNumbers{1, 1, 1, 1, 1});
    // Island 1 sends to island 0 in exchanges 2, 4, 6 ..., island 2 in exchanges 3, 6, 9 ..., so both do in the sixth.
    CHECK(most("sequential", {{1}, {3, 0}, {3, 1, 0}, {2}}) == IslandNumbers{2, 2, 1, 2});
    CHECK(most("broadcast", Neighbours(2)) == IslandNumbers{0, 0});
}

TEST_CASE("schedules are named by their text") {
    CHECK(Schedule().text() == "broadcast(every = 3)");
    CHECK(Schedule::named("sequential(10)").text() == "sequential(every = 10)");
}
