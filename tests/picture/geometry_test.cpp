#include "picture/geometry.hpp"

#include <doctest/doctest.h>

#include <random>

namespace picture = placedpar::picture;
using picture::Box;

namespace {

const Box unit{{0, 0}, 2, 2}; ///< from -1 to 1, across and down

bool holds(const Box& box, picture::Point p) {
    return p.x > box.left() && p.x < box.right() && p.y > box.top() && p.y < box.bottom();
}

} // namespace

TEST_CASE("boxes that share only a border do not overlap") {
    CHECK(overlap(unit, {{1, 1}, 2, 2}));
    CHECK(overlap(unit, {{0, 0}, 1, 1})); // one contains the other
    CHECK_FALSE(overlap(unit, {{2, 0}, 2, 2}));
    CHECK_FALSE(overlap(unit, {{2, 2}, 2, 2}));
    CHECK_FALSE(overlap(unit, {{0, 5}, 2, 2}));
    CHECK(overlap(grown(unit, .5), {{2, 0}, 2, 2}));
}

TEST_CASE("a line crosses a box if a part of it lies inside") {
    CHECK(crosses(unit, {-2, 0}, {2, 0}));
    CHECK(crosses(unit, {-2, -2}, {2, 2}));
    CHECK(crosses(unit, {0, 0}, {5, 5}));         // it begins inside
    CHECK_FALSE(crosses(unit, {-2, 1}, {2, 1}));  // along the border
    CHECK_FALSE(crosses(unit, {-2, 0}, {-1, 0})); // it ends on the border
    CHECK_FALSE(crosses(unit, {0, 3}, {3, 0}));
}

TEST_CASE("the crossing test agrees with a thousand points of the line") {
    std::mt19937 lots(1);
    std::uniform_real_distribution<double> place(-3, 3);
    for (int i = 0; i < 500; ++i) {
        const picture::Point a{place(lots), place(lots)}, b{place(lots), place(lots)};
        bool inside = false;
        for (int part = 0; part <= 1000; ++part)
            inside = inside || holds(unit, a + part / 1000. * (b - a));
        CAPTURE(a.x);
        CAPTURE(a.y);
        CAPTURE(b.x);
        CAPTURE(b.y);
        if (inside)
            CHECK(crosses(unit, a, b));
        else
            CHECK_FALSE(crosses({{0, 0}, 1.98, 1.98}, a, b)); // a corner may lie between two of the points
    }
}

TEST_CASE("the point where a line leaves a box lies on its border") {
    CHECK(way_out(unit, {0, 0}, {4, 0}) == picture::Point{1, 0});
    CHECK(way_out(unit, {0, 0}, {2, 4}) == picture::Point{.5, 1});
    CHECK(way_out(unit, {.5, 0}, {.5, -3}) == picture::Point{.5, -1});
}

TEST_CASE("the smallest box around several boxes touches the outermost of them on each side") {
    const Box all = picture::around({unit, {{4, 1}, 2, 2}, {{0, -5}, 0, 0}});
    CHECK(all.left() == -1);
    CHECK(all.right() == 5);
    CHECK(all.top() == -5);
    CHECK(all.bottom() == 2);
    CHECK(picture::around({unit}).width == unit.width);
}
