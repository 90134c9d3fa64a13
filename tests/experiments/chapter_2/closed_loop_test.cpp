// Tests the closed loop's effect on a leak with one seed. For all seeds: placedpar replay closed-loop.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace placedpar;

namespace {

const Replay& replay_of_loops() {
    static const Replay replay = test::replay_named("closed-loop", 1);
    return replay;
}

double in_loop(std::size_t table, const std::string& row, const std::string& column) {
    for (const Cell& cell : replay_of_loops().comparisons.at(table).cells)
        if (cell.row == row && cell.column == column)
            return cell.simulated;
    FAIL("no cell of " << row << ", " << column);
    return 0;
}

} // namespace

TEST_CASE("a leak lets the boom lag, more in the open loop than in the closed one, and more if it is larger") {
    const std::string lag = "lag behind the reference grows by";
    for (const char* leak : {"a leak of 0.002", "a leak of 0.004"})
        CHECK(in_loop(0, lag, leak + std::string(", open")) > 3 * in_loop(0, lag, leak + std::string(", closed")));
    for (const char* loop : {", open", ", closed"}) {
        const double small = in_loop(0, lag, "a leak of 0.002" + std::string(loop)),
                     large = in_loop(0, lag, "a leak of 0.004" + std::string(loop));
        CHECK(small > 0);
        CHECK(large > 1.5 * small);
    }
}

TEST_CASE("the share of the lag that is left in the closed loop is the quotient of both lags") {
    for (const char* leak : {"a leak of 0.002", "a leak of 0.004"}) {
        const double share = in_loop(1, "share", leak);
        CHECK(share > 0);
        CHECK(share < 25);
        const std::string lag = "lag behind the reference grows by";
        CHECK(share == doctest::Approx(100 * in_loop(0, lag, leak + std::string(", closed")) /
                                       in_loop(0, lag, leak + std::string(", open")))
                           .epsilon(0.3)); // a quotient of means, beside one of medians
    }
}

TEST_CASE("the compliance grows with the leak in both loops, so the identification sees what the lag hides") {
    for (const char* loop : {", open", ", closed"}) {
        const double small = in_loop(0, "compliance grows by", "a leak of 0.002" + std::string(loop)),
                     large = in_loop(0, "compliance grows by", "a leak of 0.004" + std::string(loop));
        CHECK(small > 2);
        CHECK(large > small);
    }
}

TEST_CASE("a voltage that is too low makes the open loop lag, one that is too high lets it run ahead") {
    const std::string lag = "lag, mean of the last second";
    const double sound = in_loop(2, lag, "sound, open");
    CHECK(in_loop(2, lag, "-40 mV, open") > in_loop(2, lag, "-20 mV, open"));
    CHECK(in_loop(2, lag, "-20 mV, open") > sound);
    CHECK(in_loop(2, lag, "+20 mV, open") < sound);
    CHECK(in_loop(2, lag, "+40 mV, open") < in_loop(2, lag, "+20 mV, open"));
    for (const char* drift : {"-40 mV", "+40 mV"}) // the closed loop corrects most of it
        CHECK(std::abs(in_loop(3, lag, drift + std::string(", closed")) - in_loop(3, lag, "sound, closed")) <
              0.5 * std::abs(in_loop(2, lag, drift + std::string(", open")) - sound));
}

TEST_CASE("an offset of the voltage does not change the compliance found by the spool, but the one by the voltage") {
    const double sound_spool = in_loop(2, "C by the spool", "sound, open"),
                 sound_voltage = in_loop(2, "C by the voltage", "sound, open");
    CHECK(sound_spool == doctest::Approx(8.6).epsilon(0.1));
    const double spool = in_loop(2, "C by the spool", "+40 mV, open") / sound_spool - 1,
                 voltage = in_loop(2, "C by the voltage", "+40 mV, open") / sound_voltage - 1;
    CHECK(std::abs(voltage) > 2 * std::abs(spool));
}

TEST_CASE("one seed gives no interval: the ends are infinite, and nothing is printed as known") {
    for (const Cell& cell : replay_of_loops().comparisons.at(0).cells)
        if (cell.row.starts_with("  from, "))
            CHECK(std::isinf(cell.simulated));
    CHECK(replay_of_loops().constants.find("K_p and K_v are calibrated") != std::string::npos);
    REQUIRE(replay_of_loops().plots.size() == 1);
    for (const Panel& panel : replay_of_loops().plots[0].plot.panels)
        for (const Series& series : panel.series)
            CHECK_FALSE(series.points.empty());
}
