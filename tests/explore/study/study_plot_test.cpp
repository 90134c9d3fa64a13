#include "explore/study/study_report.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <vector>

using namespace placedpar;

namespace {

/// Returns a study with one measurement for each value of one setting.
StudySummary swept_over(const std::vector<double>& values) {
    StudySummary summary{.netlist = "a.cfs", .version = "1", .axes = {"n"}, .measures = {"time"}, .units = {"ms"}};
    for (double value : values) {
        StudyCell cell;
        cell.add(1);
        summary.lines.push_back({.values = {fmt::format("{}", value)}, .runs = 1, .ended = {}, .cells = {cell}});
    }
    return summary;
}

/// Adds the curve of one value of a second setting, with these measurements.
void add_curve(StudySummary& summary, const std::string& name, const std::vector<double>& measured) {
    StudyCell cell;
    for (double each : measured)
        cell.add(each);
    cell.close();
    summary.lines.push_back({.values = {"1", name}, .runs = measured.size(), .ended = {}, .cells = {cell}});
}

bool is_drawn_by_decades_over(const std::vector<double>& values) {
    return summary_plot(swept_over(values), "").panels.front().x.logarithmic;
}

} // namespace

TEST_CASE("the axis of a plot is logarithmic for multiplied values and linear for added values") {
    CHECK(is_drawn_by_decades_over({1, 2, 4, 8, 16, 32, 64}));
    CHECK(is_drawn_by_decades_over({5, 10, 20, 40, 1000}));
    CHECK(is_drawn_by_decades_over({10, 1000}));
    CHECK_FALSE(is_drawn_by_decades_over({1, 2, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48}));
    CHECK_FALSE(is_drawn_by_decades_over({1, 10, 20}));
    CHECK_FALSE(is_drawn_by_decades_over({0, 1, 2, 4, 100}));
}

TEST_CASE("points are plotted at the measured values, with Student's intervals if runs differ") {
    StudySummary summary{.netlist = "a.cfs", .version = "1", .axes = {"n", "k"}, .measures = {"time"}, .units = {"ms"}};
    add_curve(summary, "differ", {1, 3});
    add_curve(summary, "agree", {2, 2});
    add_curve(summary, "once", {2});
    const Panel panel = summary_plot(summary, "n").panels.front();
    REQUIRE(panel.series.size() == 3);
    CHECK(panel.x.label == "n");
    CHECK(panel.series[0].name == "k = differ");
    for (const Series& series : panel.series) {
        CHECK(series.points.front().x == 1);
        CHECK(series.points.front().y == 2);
    }
    REQUIRE(panel.series[0].intervals.size() == 1);
    CHECK(panel.series[0].intervals[0].high == doctest::Approx(2 + 12.7062)); // Student's t with one degree of freedom
    CHECK(panel.series[0].intervals[0].low == doctest::Approx(2 - 12.7062));
    CHECK(panel.series[1].intervals.empty());
    CHECK(panel.series[2].intervals.empty());
}
