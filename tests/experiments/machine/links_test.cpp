// Tests link rates against table 8.1 of the databook.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

using namespace placedpar;

TEST_CASE("links have the databook's data rates") {
    const Replay replay = test::replay_named("links");
    const std::map<std::string, double> databook{{"5 Mbit/s, one way", 450},   {"5 Mbit/s, both ways", 670},
                                                 {"10 Mbit/s, one way", 910},  {"10 Mbit/s, both ways", 1250},
                                                 {"20 Mbit/s, one way", 1740}, {"20 Mbit/s, both ways", 2350}};
    for (const auto& each : databook) {
        const auto cells = test::row_named(replay.comparisons.at(0), each.first);
        REQUIRE(cells.size() == 1);
        CHECK(cells[0].simulated == doctest::Approx(each.second).epsilon(0.03));
        CHECK(cells[0].reference == each.second);
    }
}

TEST_CASE("each switch slows a link down, and no link exceeds its bit rate") {
    const Replay replay = test::replay_named("links");
    auto rate = [&](const char* row) { return test::row_named(replay.comparisons.at(1), row).at(0).simulated; };
    CHECK(rate("direct") > rate("through one C004"));
    CHECK(rate("through one C004") > rate("through three C004"));
    CHECK(rate("direct") < 20'000.0 / 11); // 11 bits a byte
}
