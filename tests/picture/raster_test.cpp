#include "picture/raster.hpp"

#include <doctest/doctest.h>

namespace picture = placedpar::picture;
using namespace picture;

namespace {

const Box area{{80, 80}, 160, 160};

} // namespace

TEST_CASE("a wire leads around a box with the fewest bends") {
    Raster raster(area, {{{80, 80}, 32, 80}});
    auto way = raster.find({{{0, 80}, {1, 0}}}, {{{160, 80}, {-1, 0}}});
    REQUIRE(way);
    CHECK(way->size() == 6); // four bends
    CHECK(way->front() == picture::Point{0, 80});
    CHECK(way->back() == picture::Point{160, 80});
    for (std::size_t i = 0; i + 1 < way->size(); ++i)
        CHECK_FALSE(crosses({{80, 80}, 32, 80}, (*way)[i], (*way)[i + 1]));
}

TEST_CASE("wires may cross, but do not overlap or share ends") {
    Raster raster(area, {});
    raster.add({{80, 0}, {80, 160}});
    auto across = raster.find({{{0, 80}, {1, 0}}}, {{{160, 80}, {-1, 0}}});
    REQUIRE(across);
    CHECK(across->size() == 2);
    CHECK_FALSE(raster.find({{{80, 0}, {0, 1}}}, {{{160, 80}, {-1, 0}}})); // its end is occupied
    raster.add(*across);
    CHECK_FALSE(raster.find({{{0, 80}, {1, 0}}}, {{{160, 80}, {-1, 0}}}));
}

TEST_CASE("an unreachable target has no route") {
    Raster raster(area, {});
    raster.block({{80, 80}, 1, 400});
    CHECK_FALSE(raster.find({{{0, 80}, {1, 0}}}, {{{160, 80}, {-1, 0}}}));
    CHECK_FALSE(Raster({{0, 0}, 1e6, 1e6}, {}).find({{{0, 80}, {1, 0}}}, {{{160, 80}, {-1, 0}}})); // too large an area
}
