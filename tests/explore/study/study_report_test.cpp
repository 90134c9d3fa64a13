// Tests a study's figures as a table for people and for programs.

#include "explore/study/study_report.hpp"

#include "tests/explore/study/cell_of.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns a study with two completed runs with one slave, and one run with two slaves that did not complete.
StudySummary of_two_lines() {
    StudySummary summary{.netlist = "farm.cfs", .version = "1", .axes = {"slaves"}, .fixed = {{"samples", "12"}}};
    summary.measures = {"time"};
    summary.units = {"ms"};
    summary.lines = {
        {.values = {"1"}, .runs = 2, .ended = {}, .cells = {test::cell_of({4, 6})}},
        {.values = {"2"}, .runs = 1, .ended = {{"refused", 1}}, .refused = "too few", .cells = {StudyCell()}}};
    return summary;
}

} // namespace

TEST_CASE("a study's table has one line for each combination, with intervals if there are several seeds") {
    CHECK(print_summary(of_two_lines()) == "farm.cfs: 3 runs of 2 combinations\n"
                                           "all with samples = 12\n"
                                           "\n"
                                           "slaves  runs  time [ms]   95 %\n"
                                           "     1     2          5   ± 13\n" // t is 12.7 for one degree of freedom
                                           "     2     1          -         refused: too few\n");
    StudySummary single = of_two_lines();
    single.lines.erase(single.lines.begin());
    CHECK(print_summary(single).find("95 %") == std::string::npos);
}

TEST_CASE("in CSV a missing figure and the interval of a single run are empty") {
    StudySummary summary = of_two_lines();
    summary.lines.push_back({.values = {"3"}, .runs = 1, .ended = {}, .cells = {test::cell_of({7.5})}});
    const std::string csv = summary_csv(summary);
    CHECK(csv.starts_with("slaves,runs,ended,time [ms] mean,time [ms] half_width_95,time [ms] least,time [ms] "
                          "greatest\n1,2,,5,12.70620"));
    CHECK(csv.ends_with(",4,6\n2,1,refused: too few,,,,\n3,1,,7.5,,7.5,7.5\n"));
}

TEST_CASE("a study that cannot be drawn is refused with the reason") {
    StudySummary summary = of_two_lines();
    CHECK_THROWS_WITH_AS(summary_plot(summary, "samples"), "\"samples\" does not have several values in this study",
                         UserError);
    summary.lines.front().cells.front() = StudyCell();
    CHECK_THROWS_WITH_AS(summary_plot(summary), "nothing to draw: no run has a value of the measures", UserError);
    summary.lines.front().values = {"few"};
    CHECK_THROWS_WITH_AS(summary_plot(summary, "slaves"),
                         "\"slaves\" has values that are not numbers, so nothing can be drawn over it", UserError);
    CHECK_THROWS_WITH_AS(summary_plot(summary), "no plot: no setting of this study has several values that are numbers",
                         UserError);
}

TEST_CASE("a plot is drawn over the axis with the most numbers, with at most eight curves for the other axes") {
    StudySummary summary{.netlist = "farm.cfs", .version = "1", .axes = {"kind", "n"}, .measures = {"time"}};
    summary.units = {""};
    auto add = [&](const std::string& kind, const std::string& n) {
        summary.lines.push_back({.values = {kind, n}, .runs = 1, .ended = {}, .cells = {test::cell_of({1})}});
    };
    for (char kind = 'a'; kind < 'i'; ++kind)
        add(std::string(1, kind), "1");
    add("a", "2");
    const Panel panel = summary_plot(summary).panels.at(0);
    CHECK(panel.x.label == "n");
    REQUIRE(panel.series.size() == 8);
    CHECK(panel.series[0].name == "kind = a");
    CHECK(panel.series[0].points.size() == 2);
    add("one too many", "1");
    CHECK_THROWS_WITH_AS(summary_plot(summary), doctest::Contains("more than 8 curves, too many to tell apart"),
                         UserError);
}
