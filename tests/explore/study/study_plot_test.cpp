#include "explore/study/study_report.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <vector>

using namespace placedpar;

namespace {

/// A study that measured something of each value of one setting.
StudySummary swept_over(const std::vector<double>& values) {
    StudySummary summary{.netlist = "a.cfs", .version = "1", .axes = {"n"}, .measures = {"time"}, .units = {"ms"}};
    for (double value : values) {
        StudyCell cell;
        cell.add(1);
        summary.lines.push_back({.values = {fmt::format("{}", value)}, .runs = 1, .ended = {}, .cells = {cell}});
    }
    return summary;
}

bool is_drawn_by_decades_over(const std::vector<double>& values) {
    return summary_plot(swept_over(values), "").panels.front().x.logarithmic;
}

} // namespace

TEST_CASE("a plot is by decades over what is multiplied, and not over what is added") {
    CHECK(is_drawn_by_decades_over({1, 2, 4, 8, 16, 32, 64}));
    CHECK(is_drawn_by_decades_over({5, 10, 20, 40, 1000}));
    CHECK(is_drawn_by_decades_over({10, 1000}));
    CHECK_FALSE(is_drawn_by_decades_over({1, 2, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48}));
    CHECK_FALSE(is_drawn_by_decades_over({1, 10, 20}));
    CHECK_FALSE(is_drawn_by_decades_over({0, 1, 2, 4, 100}));
}
