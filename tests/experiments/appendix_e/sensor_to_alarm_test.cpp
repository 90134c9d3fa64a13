// Tests the path from the sensors to the alarm with one seed. For all seeds: placedpar replay sensor-to-alarm.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

constexpr const char *leak = "leak", *sound = "sound", *busy_bus = "leak, busy bus", *five = "leak, 5 generations";
constexpr const char *to_sun = "1: bus master to Sun", *to_islands = "2: Sun to all islands",
                     *search = "3: generations, and back to the Sun", *to_alarm = "4: Sun to the other bus master",
                     *all_stages = "sensors to alarm, mean of all samples";

const Replay& replay_of_alarms() {
    static const Replay replay = test::replay_named("sensor-to-alarm", 1);
    return replay;
}

double delay_of(const char* row, const char* column) {
    for (const Cell& cell : replay_of_alarms().comparisons.at(0).cells)
        if (cell.row == row && cell.column == column)
            return cell.simulated;
    FAIL("no cell of " << row << ", " << column);
    return 0;
}

} // namespace

TEST_CASE("a leak raises the alarm, and a sound machine does not") {
    for (const char* column : {leak, busy_bus, five})
        CHECK(delay_of("alarm raised", column) == 100);
    CHECK(delay_of("alarm raised", sound) == 0);
    CHECK(replay_of_alarms().within_tolerance());
}

TEST_CASE("the stages follow each other, so their delays add up to the whole") {
    for (const char* column : {leak, sound}) {
        double sum = 0;
        for (const char* stage : {to_sun, to_islands, search, to_alarm})
            sum += delay_of(stage, column);
        CHECK(delay_of(all_stages, column) == doctest::Approx(sum).epsilon(0.02));
        CHECK(delay_of("  the longest", column) >= delay_of(all_stages, column));
    }
}

TEST_CASE("two generations take less than the 20 ms between samples, and five do not: samples queue up") {
    CHECK(delay_of(search, leak) < 20);
    CHECK(delay_of(search, five) > 2 * delay_of(search, leak));
    CHECK(delay_of(to_sun, five) > 20); // the Sun is still busy with earlier samples
    CHECK(delay_of("  the longest", leak) < 20);
}

TEST_CASE("a busy bus delays the stages that use it, and hardly the search") {
    CHECK(delay_of("bus busy", busy_bus) > 50);
    CHECK(delay_of("bus busy", leak) < 5);
    for (const char* stage : {to_sun, to_islands, to_alarm})
        CHECK(delay_of(stage, busy_bus) > 5 * delay_of(stage, leak));
    CHECK(delay_of(search, busy_bus) < 1.5 * delay_of(search, leak));
}

TEST_CASE("the fault does not change the delays, only the alarm") {
    for (const char* row : {to_sun, to_islands, search, to_alarm, all_stages})
        CHECK(delay_of(row, sound) == doctest::Approx(delay_of(row, leak)).epsilon(0.01));
    CHECK(test::row_named(replay_of_alarms().comparisons[0], "last reading to alarm").size() == 3); // of the leaks
}

TEST_CASE("the drawing has both delays of each stage, on the idle and on the busy bus") {
    REQUIRE(replay_of_alarms().drawings.size() == 1);
    const std::string& svg = replay_of_alarms().drawings[0].svg;
    for (const char* board : {"BBK-V2", "Sun 3/280", "4 VMTM, 16 T800"})
        CHECK(svg.find(board) != std::string::npos);
    for (const char* stage : {">1: ", ">2: ", ">3: ", ">4: "})
        CHECK(svg.find(stage) != std::string::npos);
}
