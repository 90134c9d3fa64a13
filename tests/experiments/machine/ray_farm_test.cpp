// Tests a farm on 73 transputers against published times.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

// This takes half a minute: ctest -C studies -R studies/farm. Nine of these cells belong to the evidence.
TEST_CASE("a farm takes longer with low-priority routers or costlier packets" * doctest::skip()) {
    const Replay farm = test::replay_named("ray-farm");
    auto seconds = [&](int workers, const std::string& routers) {
        const auto cells = test::row_named(farm.comparisons.at(0),
                                           "farm of " + std::to_string(workers) + " workers, routers " + routers);
        CAPTURE(workers);
        REQUIRE(cells.size() == 1);
        return cells[0].simulated;
    };
    const std::string slow = "high, 4500 cycles a packet";
    CHECK(seconds(71, "high") < seconds(71, slow));
    CHECK(seconds(71, slow) < seconds(71, "low"));
    CHECK(seconds(11, slow) > 2.5 * seconds(35, slow));
    CHECK(seconds(35, "low") < 1.05 * seconds(71, "low")); // more workers do not help any further
    CHECK(farm.within_tolerance());
}
