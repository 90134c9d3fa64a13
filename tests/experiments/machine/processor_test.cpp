// Tests a transputer's scheduler and memory against the databook, and messages against measurements in Poznan.

#include "runtime/hardware/constants.hpp"
#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the only figure of a row in one of a replay's tables.
double figure_of(const Replay& replay, std::size_t table, const std::string& row) {
    const auto cells = test::row_named(replay.comparisons.at(table), row);
    CAPTURE(row);
    REQUIRE(cells.size() == 1);
    return cells[0].simulated;
}

} // namespace

TEST_CASE("clocks tick every microsecond, or every 64 microseconds at low priority") {
    const Replay replay = test::replay_named("processor");
    CHECK(figure_of(replay, 0, "clock of high priority") == doctest::Approx(1).epsilon(0.001));
    CHECK(figure_of(replay, 0, "clock of low priority") == doctest::Approx(64).epsilon(0.001));
}

TEST_CASE("a turn beside another takes one to two periods, and a wait beside n - 1 others 2n - 2 at most") {
    const Replay replay = test::replay_named("processor");
    const double shortest = figure_of(replay, 0, "turn beside another, shortest"),
                 longest = figure_of(replay, 0, "turn beside another, longest");
    CHECK(shortest >= 1);
    CHECK(shortest < 1.05);
    CHECK(longest <= 2);
    CHECK(longest > 1.95);
    for (int others : {1, 3, 7}) {
        const std::string row =
            "wait beside " + std::to_string(others) + (others == 1 ? " other" : " others") + ", longest";
        const double periods = figure_of(replay, 0, row);
        CHECK(periods <= 2.0 * others + 0.01); // a few cycles for switching
        CHECK(periods > 2.0 * others - 0.2);
    }
}

TEST_CASE("copying takes 6 cycles a word outside the chip and 2 on it, at 20 MHz") {
    const Replay replay = test::replay_named("processor");
    CHECK(figure_of(replay, 1, "copy outside of the chip") == doctest::Approx(20.0 * 4 / 6).epsilon(0.005));
    CHECK(figure_of(replay, 1, "copy on the chip") == doctest::Approx(20.0 * 4 / 2).epsilon(0.005));
    CHECK(figure_of(replay, 1, "crossbar switch, one way") == doctest::Approx(1.75).epsilon(0.01));
}

TEST_CASE("half a round trip takes Poznan's 11 us plus 2.25 us a word, or 4.30 us a word through three switches") {
    const Replay replay = test::replay_named("poznan");
    CHECK(std::abs(figure_of(replay, 0, "half a round trip, to start") - 11) <= 0.2);
    CHECK(figure_of(replay, 0, "half a round trip, a word") == doctest::Approx(2.25).epsilon(0.01));
    CHECK(figure_of(replay, 0, "a word through three C004") == doctest::Approx(4.3).epsilon(0.01));
}

TEST_CASE("programs of emulated transputers measure the databook's latencies, turns, copies and links") {
    const Replay replay = test::replay_named("emulated");
    CHECK(replay.within_tolerance());
    CHECK(figure_of(replay, 0, "code: interrupt, typical") == 19);
    CHECK(figure_of(replay, 0, "code: interrupt of divisions, longest") == 58);
    CHECK(figure_of(replay, 0, "code: interrupt of floating point, longest") > 39 + 16); // a step of a root takes 42
    CHECK(figure_of(replay, 0, "code: interrupt of floating point, longest") <= 78);
    CHECK(figure_of(replay, 1, "code: move outside of the chip") == doctest::Approx(20.0 * 4 / 6).epsilon(0.002));
    CHECK(figure_of(replay, 1, "code: fetching a word outside of the chip") == doctest::Approx(1).epsilon(0.03));
    CHECK(figure_of(replay, 1, "code: a loop of COMMSTIME") == doctest::Approx(282 - 8).epsilon(0.002)); // by the table
    // Emulated transputers and processes in C++ use the same links.
    const Replay links = test::replay_named("links");
    for (const char* row : {"5 Mbit/s, one way", "10 Mbit/s, one way", "20 Mbit/s, one way", "20 Mbit/s, both ways"})
        CHECK(figure_of(replay, 2, std::string("code: ") + row) ==
              doctest::Approx(figure_of(links, 0, row)).epsilon(0.003));
}

// This takes half a minute: ctest -C studies -R studies/farm. tests/app/replay_test.py and the page of the timing model
// check the same replay in each run of the tests.
TEST_CASE(
    "the evidence lists every published figure of the machine's replays with its mark, and constants with sources" *
    doctest::skip()) {
    const Replay evidence = test::replay_named("evidence"); // made once for all checks, since it takes seconds
    const Comparison& figures = evidence.comparisons.at(0);
    CHECK(figures.names_origins);
    CHECK(evidence.within_tolerance());
    std::size_t others = 0;
    for (const char* name : {"links", "poznan", "processor", "emulated"})
        for (const Comparison& table : test::replay_named(name).comparisons)
            others += table.cells.size();
    CHECK(others == 26 + 18);
    CHECK(figures.cells.size() == others + 9); // nine cells belong to the farm
    REQUIRE_FALSE(evidence.constant_table.empty());
    for (const hardware::Constant& constant : evidence.constant_table)
        CHECK_FALSE_MESSAGE(constant.source.empty(), constant.name);
    for (Origin origin : {Origin::outcome, Origin::constant, Origin::calibrated, Origin::fitted})
        CHECK_MESSAGE(figures.notes.find(name_of(origin)) != std::string::npos, name_of(origin));

    std::map<Origin, std::vector<std::string>> rows;
    std::map<Origin, std::size_t> by_emulated_code;
    for (const Cell& cell : figures.cells)
        if (cell.row.starts_with("code: "))
            ++by_emulated_code[cell.origin];
        else
            rows[cell.origin].push_back(cell.row);
    CHECK(by_emulated_code ==
          std::map<Origin, std::size_t>{
              {Origin::outcome, 11}, {Origin::constant, 2}, {Origin::calibrated, 1}, {Origin::fitted, 4}});
    CHECK(rows[Origin::outcome] ==
          std::vector<std::string>{
              "5 Mbit/s, one way", "10 Mbit/s, one way", "no overlapped acknowledges", "through one C004",
              "turn beside another, shortest", "turn beside another, longest", "wait beside 1 other, longest",
              "wait beside 3 others, longest", "wait beside 7 others, longest", "farm of 71 workers, routers high",
              "farm of 11 workers, routers low", "farm of 35 workers, routers low", "farm of 71 workers, routers low",
              "farm of 17 workers, routers high, 4500 cycles a packet",
              "farm of 35 workers, routers high, 4500 cycles a packet",
              "farm of 53 workers, routers high, 4500 cycles a packet"});
    CHECK(rows[Origin::constant] ==
          std::vector<std::string>{"clock of high priority", "clock of low priority", "interrupt, typical",
                                   "interrupt of divisions, longest", "interrupt of floating point, longest",
                                   "copy outside of the chip", "copy on the chip", "crossbar switch, one way"});
    CHECK(rows[Origin::calibrated] ==
          std::vector<std::string>{"half a round trip, to start",
                                   "farm of 11 workers, routers high, 4500 cycles a packet",
                                   "farm of 71 workers, routers high, 4500 cycles a packet"});
    CHECK(rows[Origin::fitted].size() == 8);
    CHECK(rows[Origin::workload].empty());
}
