// Tests the cells of a summary as text.

#include "explore/study/summary_cells.hpp"

#include "tests/explore/study/cell_of.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

TEST_CASE("a mean has six digits, an interval two; without runs there is neither") {
    CHECK(shown_mean(test::cell_of({1.0 / 3})) == "0.333333");
    CHECK(shown_mean(test::cell_of({1234567.8})) == "1.23457e+06");
    CHECK(shown_mean(StudyCell()) == "-");
    CHECK(shown_interval(StudyCell()) == "");
    CHECK(shown_interval(test::cell_of({5})) == "");
    CHECK(shown_interval(test::cell_of({5, 5})) == "± 0");
    CHECK(shown_interval(test::cell_of({4, 6, 8})) == "± 5"); // 4.303 * 2 / sqrt(3)
}

TEST_CASE("how runs ended is stated with their number, or without it if all ended so") {
    StudyLine line{.values = {}, .runs = 5, .ended = {}, .cells = {}};
    CHECK(ended_of(line) == "");
    line.ended = {{"deadlock", 3}, {"refused", 2}};
    line.refused = "too few links";
    CHECK(ended_of(line) == "3 deadlock, 2 refused: too few links");
    line.ended = {{"deadlock", 5}};
    line.refused = "";
    CHECK(ended_of(line) == "deadlock");
}

TEST_CASE("a heading has the unit, and says if a measure is relative or has the name of a setting") {
    StudySummary summary{.netlist = "n.cfs", .version = "1", .axes = {"links"}};
    summary.measures = {"links", "m.T"};
    summary.units = {"", "ms"};
    CHECK(measure_with_unit(summary, 0) == "links measured");
    CHECK(measure_with_unit(summary, 1) == "m.T [ms]");
    summary.relative_to = {{"n", "0"}};
    CHECK(measure_with_unit(summary, 1) == "relative m.T [ms]");
}

TEST_CASE("intervals are shown if some combination has several runs") {
    StudySummary summary{.netlist = "n.cfs", .version = "1"};
    CHECK_FALSE(has_intervals(summary));
    summary.lines = {{.values = {}, .runs = 1, .ended = {}, .cells = {}}};
    CHECK_FALSE(has_intervals(summary));
    summary.lines.push_back({.values = {}, .runs = 2, .ended = {}, .cells = {}});
    CHECK(has_intervals(summary));
}

TEST_CASE("sentences for all lines state shared settings and the reference, and count runs without one") {
    StudySummary summary{.netlist = "n.cfs", .version = "1"};
    CHECK(said_of_all(summary).empty());
    summary.fixed = {{"clock", "5M"}, {"n", "3"}};
    summary.relative_to = {{"slaves", "0"}};
    summary.unrelated = 1;
    CHECK(said_of_all(summary) ==
          std::vector<std::string>{"all with clock = 5M, n = 3", "relative to slaves = 0",
                                   "no relative figures for 1 run: no run with the settings above and the same seed "
                                   "ended in the same way"});
}

TEST_CASE("a reference that no run has is described with the settings that there are") {
    CHECK(there_is_no_reference({{"slaves", "0"}}, {"clock", "slaves"}) ==
          "no combination has slaves = 0, so figures cannot be relative to it; the runs set clock, slaves");
    CHECK(there_is_no_reference({{"slaves", "0"}}, {}) ==
          "no combination has slaves = 0, so figures cannot be relative to it; the runs have no settings");
}
