// Tests Table E.1 of the thesis, and relations between its rows.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace placedpar;

TEST_CASE("a generation with 0 to 3 slaves: the thesis's milliseconds to 3 %, and their sums") {
    const Replay replay = test::replay_named("table-e1");
    const Comparison& table = replay.comparisons.at(0);
    const std::map<std::string, std::vector<double>> known{{"T_exe", {97.0, 54.0, 39.7, 32.8}},
                                                           {"T_sr", {86.4, 43.3, 29.5, 22.5}},
                                                           {"P_time2", {86.4, 43.3, 29.0, 21.8}},
                                                           {"C_time2", {0.0, 0.6, 1.28, 1.89}},
                                                           {"S_time2", {10.5, 10.5, 10.5, 10.5}}};
    std::map<std::string, std::vector<Cell>> rows;
    for (const auto& each : known) {
        rows[each.first] = test::row_named(table, each.first);
        REQUIRE(rows[each.first].size() == 4);
        for (std::size_t slaves = 0; slaves < 4; ++slaves) {
            CHECK(rows[each.first][slaves].reference == each.second[slaves]);
            CHECK(std::abs(rows[each.first][slaves].simulated - each.second[slaves]) <= 0.03 * each.second[slaves]);
        }
    }
    auto ms = [&](const char* row, std::size_t slaves) { return rows.at(row)[slaves].simulated; };
    for (std::size_t slaves = 0; slaves < 4; ++slaves) {
        CHECK(ms("T_exe", slaves) == doctest::Approx(ms("T_sr", slaves) + ms("S_time2", slaves)).epsilon(0.01));
        CHECK(ms("P_time2", slaves) ==
              doctest::Approx(ms("P_time2", 0) / (1.0 + static_cast<double>(slaves))).epsilon(0.01));
    }
    CHECK(ms("T_sr", 3) - ms("P_time2", 3) < ms("C_time2", 3)); // some of the communication overlaps with computing
    // The stated constants are those of the netlist, for 120 individuals (and for 30).
    CHECK(replay.constants.find(
              "1440 cycles for an error evaluation (5760 under the reading 30) and 1750 (7000) cycles") !=
          std::string::npos);
    CHECK(replay.constants.find("148 bytes of measurements") != std::string::npos);
    CHECK(replay.within_tolerance());
}
