// Tests the ends that axes get, and the shift of curves whose intervals lie at one x.

#include "picture/plot_room.hpp"

#include "picture/plot.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

Panel panel_with(const std::vector<Point>& points) { return {"", {}, {}, {{"", points}}}; }

Series with_bars(const std::vector<Point>& points) {
    return {.name = "", .points = points, .intervals = std::vector<Interval>(points.size(), Interval{0, 1})};
}

} // namespace

TEST_CASE("an axis whose values are equal is widened by half of the value on each side, or by 1 around 0") {
    const Panel wide = with_wide_axes(panel_with({{40, 0}, {40, 0}}));
    CHECK(wide.x.from == 20);
    CHECK(wide.x.to == 60);
    CHECK(wide.y.from == -1);
    CHECK(wide.y.to == 1);
    const Panel below = with_wide_axes(panel_with({{1, -8}}));
    CHECK(below.y.from == -12);
    CHECK(below.y.to == -4);
}

TEST_CASE("an axis with different values, or with an end of its own, is left as it is") {
    CHECK_FALSE(with_wide_axes(panel_with({{1, 2}, {3, 2}})).x.from);
    Panel fixed = panel_with({{1, 2}});
    fixed.y.from = 0;
    CHECK_FALSE(with_wide_axes(fixed).y.to);
    CHECK(with_wide_axes(fixed).y.from == 0);
}

TEST_CASE("bars, bands and marks count as values; what is not finite does not") {
    Panel barred = panel_with({{1, 2}});
    barred.series[0].intervals = {{1, 3}};
    CHECK_FALSE(with_wide_axes(barred).y.from);
    Panel marked = panel_with({{1, 2}});
    marked.marks = {{"limit", 5}};
    CHECK_FALSE(with_wide_axes(marked).y.from);
    CHECK(with_wide_axes(marked).x.from); // a mark has no x
    Panel banded = panel_with({{1, 2}});
    banded.bands = {{"", {{1, 2, 4}}, 0}};
    CHECK_FALSE(with_wide_axes(banded).y.from);
    CHECK(with_wide_axes(panel_with({{1, 2}, {1, std::numeric_limits<double>::quiet_NaN()}})).y.from == 1);
}

TEST_CASE("only curves that have bars at a common x are shifted, evenly around this x") {
    Panel panel{"", {}, {}, {with_bars({{1, 0}, {2, 0}}), with_bars({{2, 1}}), with_bars({{3, 1}})}};
    CHECK(column_of_x(panel, 1, 0) == "($1+(Xto1-Xfrom1)*(-0.004))");
    CHECK(column_of_x(panel, 1, 1) == "($1+(Xto1-Xfrom1)*(0.004))");
    CHECK(column_of_x(panel, 1, 2) == "1");
    panel.series.push_back({"", {{2, 5}}}); // without bars
    CHECK(column_of_x(panel, 1, 3) == "1");
    panel.x.logarithmic = true;
    CHECK(column_of_x(panel, 2, 0) == "($1*(Xto2/Xfrom2)**(-0.004))");
}

TEST_CASE("an end at which a curve is cut off gets no room") {
    Panel panel = panel_with({{0, 0}, {10, 10}});
    CHECK(room_commands(panel, 1).find("Yto1 = 1 && 10 > ") != std::string::npos);
    panel.y.to = 5;
    const std::string cut = room_commands(panel, 1);
    CHECK(cut.find("Yto1 = 0 && 10 > ") != std::string::npos);
    CHECK(cut.find("Yfrom1 = 1 && 0 < ") != std::string::npos);
    CHECK(cut.find("Xto1 = 1 && ") != std::string::npos);
}
