#include "picture/cut_off.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace placedpar;

namespace {

/// Returns a panel whose axes both go from 0 to 10.
Panel square_panel() { return {"panel", {"x", 0, 10}, {"y", 0, 10}, {}}; }

std::vector<CutOff> cut_offs_of(std::vector<Point> points, Stroke stroke = Stroke::line,
                                const Panel& panel = square_panel()) {
    return cut_offs({"curve", std::move(points), stroke}, panel);
}

} // namespace

TEST_CASE("a curve within its panel is not cut off, nor one that touches an edge") {
    CHECK(cut_offs_of({{0, 0}, {5, 10}, {10, 0}}).empty());
    CHECK(cut_offs_of({{0, 10 + 1e-9}, {10 + 1e-9, 0}}).empty());
    CHECK(text_of(std::vector<CutOff>{}).empty());
}

TEST_CASE("a curve is cut off where its line crosses the edge") {
    const auto top = cut_offs_of({{0, 5}, {4, 15}, {8, 5}});
    REQUIRE(top.size() == 1);
    CHECK(top[0].edge == PanelEdge::top);
    CHECK(top[0].farthest == 15);
    REQUIRE(top[0].places.size() == 1);
    CHECK(top[0].places[0] == doctest::Approx(2));
    CHECK(text_of(top) == " \u2191 to 15");

    const auto left = cut_offs_of({{-6, 0}, {4, 5}});
    REQUIRE(left.size() == 1);
    CHECK(left[0].edge == PanelEdge::left);
    CHECK(left[0].places[0] == doctest::Approx(3));
    CHECK(text_of(left) == " \u2190 to -6");
}

TEST_CASE("each crossing of each edge counts") {
    const auto cut = cut_offs_of({{0, 12}, {1, 8}, {2, 12}, {3, 8}, {4, -2}, {5, 8}, {15, 8}});
    REQUIRE(cut.size() == 3);
    CHECK(cut[0].places.size() == 2);
    CHECK(cut[0].places[0] == doctest::Approx(0.5)); // it begins outside, so the cut is where it enters
    CHECK(cut[0].places[1] == doctest::Approx(1.5));
    CHECK(text_of(cut) == " \u2191 to 12 \u2193 to -2 \u2192 to 15");
}

TEST_CASE("crossings on a logarithmic axis lie on the drawn straight line") {
    Panel panel = square_panel();
    panel.y = {"y", 1, 10, true};
    const auto cut = cut_offs_of({{0, 1}, {4, 100}}, Stroke::line, panel);
    REQUIRE(cut.size() == 1);
    CHECK(cut[0].places[0] == doctest::Approx(2));
    CHECK(text_of(cut_offs_of({{0, 5}, {4, 0}}, Stroke::line, panel)) == " \u2193 to 0");
}

TEST_CASE("points beyond both axes or not finite do not count as cut off") {
    CHECK(cut_offs_of({{11, 5}, {12, 15}}).size() == 1); // only to the right, decided by the first point
    CHECK(cut_offs_of({{11, 11}, {12, 15}}).empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(cut_offs_of({{1, 5}, {2, nan}, {3, 5}}).empty());
    const auto alone = cut_offs_of({{1, nan}, {2, 15}, {3, nan}});
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].places[0] == 2);
}

TEST_CASE("points outside are marked at the edge above or below") {
    const auto cut = cut_offs_of({{1, 5}, {2, 15}, {3, 5}}, Stroke::points);
    REQUIRE(cut.size() == 1);
    CHECK(cut[0].places == std::vector{2.0});
}

TEST_CASE("an axis without fixed ends cuts nothing off") {
    Panel panel = square_panel();
    panel.y = {"y"};
    CHECK(cut_offs_of({{1, 5}, {2, 15}, {3, -5}}, Stroke::line, panel).empty());
}
