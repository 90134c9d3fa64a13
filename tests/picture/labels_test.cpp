#include "picture/labels.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace picture = placedpar::picture;
using picture::Box;
using picture::LabelRoom;
using picture::Path;

namespace {

const Path across{{0, 0}, {100, 0}}; ///< a line to the right

} // namespace

TEST_CASE("a label stands beside the beginning of its wire, and does not lie on it") {
    LabelRoom room({});
    room.add_wire(0, across);
    const auto label = room.beside_start(0, across, 10, 8);
    REQUIRE(label);
    CHECK_FALSE(crosses(*label, across[0], across[1]));
    CHECK(label->centre.x < 30);
    CHECK(std::abs(label->centre.y) < 12);
}

TEST_CASE("labels at one place do not overlap; labels without room are left out") {
    LabelRoom room({});
    std::vector<Box> labels;
    while (auto label = room.beside_start(0, across, 10, 8))
        labels.push_back(*label);
    CHECK(labels.size() >= 4);
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE(overlap(labels[i], labels[j]));
}

TEST_CASE("no label lies on a box") {
    const Box box{{10, -8}, 30, 14}; // the label's usual place
    LabelRoom room({box});
    const auto label = room.beside_start(0, across, 10, 8);
    REQUIRE(label);
    CHECK_FALSE(overlap(*label, box));
    CHECK_FALSE(LabelRoom({{{50, 0}, 200, 100}}).beside_start(0, across, 10, 8));
}

TEST_CASE("a label avoids other wires if possible") {
    LabelRoom free({});
    const auto first_choice = free.on_middle(0, across, 12, 10);
    REQUIRE(first_choice);
    CHECK(first_choice->centre == picture::Point{50, 0});

    LabelRoom crossed({});
    crossed.add_wire(1, {{50, -40}, {50, 40}});
    const auto beside = crossed.on_middle(0, across, 12, 10);
    REQUIRE(beside);
    CHECK_FALSE(crosses(*beside, {50, -40}, {50, 40}));

    LabelRoom full({});
    for (double x = -5; x < 105; x += 4)
        full.add_wire(1, {{x, -40}, {x, 40}});
    REQUIRE(full.on_middle(0, across, 12, 10));
    CHECK(full.beside_start(0, across, 12, 10));
}

TEST_CASE("a wire of length 0 has no label") { CHECK_FALSE(LabelRoom({}).beside_start(0, {{5, 5}, {5, 5}}, 10, 8)); }

TEST_CASE("the label belongs to the first of a path's longest lines") {
    CHECK(picture::longest_line({{0, 0}, {1, 0}, {1, 9}, {10, 9}}) == 1);
    CHECK(picture::longest_line({{0, 0}, {3, 0}}) == 0);
}
