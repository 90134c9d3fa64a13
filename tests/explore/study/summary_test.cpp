// Tests the summary of many runs in one table.

#include "explore/study/summary.hpp"

#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "tests/explore/study/cell_of.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Adds runs of a made-up machine: rate = slaves + seed / 10, and a deadlock with 9 slaves.
StudyResults& add_runs(StudyResults& results, const std::vector<std::string>& slaves, std::uint64_t seeds) {
    for (const std::string& each : slaves)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const double rate = std::stod(each) + .1 * static_cast<double>(seed);
            StudyOutcome outcome{.ended = each == "9" ? "deadlock" : "completed",
                                 .figures = {{"master.rate", {rate, "1/s"}}}};
            results.keep({{{"slaves", each}, {"samples", "12"}}, seed}, outcome);
        }
    return results;
}

const StudyLine& line_with(const StudySummary& summary, const std::string& slaves) {
    for (const StudyLine& line : summary.lines)
        if (line.values == std::vector{slaves})
            return line;
    FAIL("no line of " << slaves << " slaves");
    return summary.lines.front();
}

} // namespace

TEST_CASE("a cell has the mean, the least and greatest value, and Student's interval") {
    const StudyCell cell = test::cell_of({1, 2, 3, 4, 5});
    CHECK(cell.mean == doctest::Approx(3));
    CHECK(cell.least == 1);
    CHECK(cell.greatest == 5);
    CHECK(cell.half_width == doctest::Approx(2.776445 * std::sqrt(2.5 / 5)).epsilon(1e-6)); // Student's t with 4
                                                                                            // degrees of freedom, at
                                                                                            // 97.5 %
    CHECK(test::cell_of({7}).half_width == 0);
    CHECK(shown_interval(test::cell_of({7})).empty());
    CHECK(shown_mean(StudyCell{}) == "-");
}

TEST_CASE("a mean of large numbers with small differences keeps its digits") {
    const StudyCell cell = test::cell_of({1e9 + 1, 1e9 + 2, 1e9 + 3});
    CHECK(cell.mean == doctest::Approx(1e9 + 2).epsilon(1e-15));
    CHECK(cell.half_width == doctest::Approx(4.302653 / std::sqrt(3)).epsilon(1e-6));
}

TEST_CASE("settings that vary are axes in numerical order; constant settings are stated once") {
    StudyResults results(StudySource{});
    const StudySummary summary = summary_of(add_runs(results, {"10", "2", "1"}, 3), {"master.rate"});
    CHECK(summary.axes == std::vector<std::string>{"slaves"});
    CHECK(summary.fixed == Overrides{{"samples", "12"}});
    CHECK(said_of_all(summary) == std::vector<std::string>{"all with samples = 12"});
    std::vector<std::string> order;
    for (const StudyLine& line : summary.lines)
        order.push_back(line.values.front());
    CHECK(order == std::vector<std::string>{"1", "2", "10"});
    CHECK(summary.runs() == 9);
    CHECK(line_with(summary, "2").cells[0].mean == doctest::Approx(2.2));
    CHECK(summary.units == std::vector<std::string>{"1/s"});
    CHECK(measure_with_unit(summary, 0) == "master.rate [1/s]");
}

TEST_CASE("runs that did not complete are counted by how they ended, and a deadlock has no figures") {
    StudyResults results(StudySource{});
    const StudySummary summary = summary_of(add_runs(results, {"1", "9"}, 2), {"master.rate"});
    CHECK(line_with(summary, "9").cells[0].runs == 0);
    CHECK(ended_of(line_with(summary, "9")) == "deadlock"); // all runs
    CHECK(ended_of(line_with(summary, "1")).empty());
    CHECK(has_intervals(summary));
}

TEST_CASE("completed runs that measured no number are counted, and are not part of the mean") {
    StudyResults results(StudySource{});
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        results.keep({{{"slaves", "1"}}, seed},
                     {.ended = "completed", .figures = {{"island.best", {seed == 2 ? std::nan("") : 4, ""}}}});
    const StudySummary summary = summary_of(results, {"island.best"});
    CHECK(summary.lines[0].cells[0].runs == 2);
    CHECK(summary.lines[0].cells[0].mean == 4);
    CHECK(ended_of(summary.lines[0]) == "1 without island.best");
}

TEST_CASE("a relative figure is the ratio of two figures of the same seed") {
    StudyResults results(StudySource{});
    const StudySummary summary =
        summary_of(add_runs(results, {"1", "2"}, 2), {"master.rate"}, nullptr, {{"slaves", "1"}});
    CHECK(line_with(summary, "1").cells[0].mean == doctest::Approx(1));
    CHECK(line_with(summary, "1").cells[0].half_width == doctest::Approx(0));
    CHECK(line_with(summary, "2").cells[0].mean == doctest::Approx((2.1 / 1.1 + 2.2 / 1.2) / 2));
    CHECK(summary.unrelated == 0);
    CHECK(summary.units == std::vector<std::string>{""});
}

TEST_CASE("figures without a reference run are counted, and the message names the settings of the runs") {
    StudyResults results(StudySource{});
    const StudySummary summary =
        summary_of(add_runs(results, {"1", "2"}, 2), {"master.rate"}, nullptr, {{"slaves", "5"}});
    CHECK(summary.unrelated == 4);
    CHECK_FALSE(summary.has_some({{"slaves", "5"}}));
    CHECK(summary.has_some({{"slaves", "2"}, {"samples", "12"}}));
    CHECK(there_is_no_reference({{"slaves", "5"}}, summary.names()).find("slaves") != std::string::npos);
}

TEST_CASE("equal values have one line, however they are spelled") {
    StudyResults results(StudySource{});
    add_runs(results, {"8"}, 1);
    results.keep({{{"slaves", "8.0"}, {"samples", "12"}}, 2},
                 {.ended = "completed", .figures = {{"master.rate", {9, "1/s"}}}});
    const StudySummary summary = summary_of(results, {"master.rate"});
    REQUIRE(summary.lines.size() == 1);
    CHECK(summary.lines[0].runs == 2);
}

TEST_CASE("in long form each run has a row, with settings, seed, ending and measures") {
    StudyResults results(StudySource{});
    CHECK(runs_csv(summary_of(add_runs(results, {"10", "2", "9"}, 2), {"master.rate"})) ==
          "slaves,samples,seed,ended,master.rate [1/s]\n2,12,1,completed,2.1\n2,12,2,completed,2.2\n"
          "9,12,1,deadlock,\n9,12,2,deadlock,\n10,12,1,completed,10.1\n10,12,2,completed,10.2\n");
}

TEST_CASE("rank tests compare the values of a setting") {
    // Ranks 1 to 5 and 6 to 10 come in 2 of 252 orders. With three groups of three in order, H is 7.2, p = exp(-3.6).
    StudyResults two(StudySource{}), three(StudySource{}), single(StudySource{});
    CHECK(print_rank_tests(summary_of(add_runs(two, {"1", "2"}, 5), {"master.rate"})) ==
          "\nRank tests\n"
          "setting  of    measure                 p  effect  test\n"
          "slaves   1, 2  master.rate [1/s]  0.0079  A 0.00  Mann-Whitney\n");
    CHECK(print_rank_tests(summary_of(add_runs(three, {"1", "2", "10", "9"}, 3), {"master.rate"})) ==
          "\nRank tests\n"
          "setting  of        measure                 p  effect          test\n"
          "slaves   3 values  master.rate [1/s]  0.0273  epsilon² 0.90   Kruskal-Wallis\n");
    CHECK(print_rank_tests(summary_of(add_runs(single, {"1", "2"}, 1), {"master.rate"})).empty());
}

TEST_CASE("rank tests say which combinations do not set a setting") {
    StudyResults results(StudySource{});
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (const Overrides& set : {Overrides{{"links", "1"}}, {{"links", "4"}}, {{"links", "4"}, {"slaves", "2"}}})
            results.keep({set, seed},
                         {.ended = "completed", .figures = {{"rate", {static_cast<double>(seed + set.size()), ""}}}});
    // With links = 4, the rates are 3, 4, 5 and 2, 3, 4. U is 7 of 9 (mean 4.5, variance 4.95 for two pairs of ties),
    // so A is .78, and z is (7 - 4.5 - .5) / sqrt(4.95) = .899.
    CHECK(print_rank_tests(summary_of(results, {"rate"})) ==
          "\nRank tests\n"
          "setting  of          with            measure       p  effect  test\n"
          "links    1, 4        slaves not set  rate     1.0000  A 0.50  Mann-Whitney\n"
          "slaves   2, not set  links = 4       rate     0.5000  A 0.78  Mann-Whitney\n");
}

TEST_CASE("rank tests hold the other settings, and leave out figures that no seed changes") {
    StudyResults results(StudySource{});
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (const char* links : {"1", "4"})
            for (const char* slaves : {"2", "3"})
                results.keep({{{"slaves", slaves}, {"links", links}}, seed},
                             {.ended = "completed",
                              .figures = {{"time", {std::stod(links) * std::stod(slaves), "ms"}},
                                          {"rate", {std::stod(slaves) + 2 * static_cast<double>(seed), ""}}}});
    // slaves = 2 has the greater rate in three of the nine pairs.
    CHECK(print_rank_tests(summary_of(results, {"time", "rate"})) ==
          "\nRank tests\n"
          "setting  of    with        measure       p  effect  test\n"
          "links    1, 4  slaves = 2  rate     1.0000  A 0.50  Mann-Whitney\n"
          "links    1, 4  slaves = 3  rate     1.0000  A 0.50  Mann-Whitney\n"
          "slaves   2, 3  links = 1   rate     0.7000  A 0.33  Mann-Whitney\n"
          "slaves   2, 3  links = 4   rate     0.7000  A 0.33  Mann-Whitney\n");
}
