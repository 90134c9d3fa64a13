#include "picture/shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace picture = placedpar::picture;
using namespace picture;

namespace {

double apart(picture::Point a, picture::Point b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); }

/// Returns the least distance between any two points.
double least_apart(const Shape& shape) {
    double least = 1e9;
    for (std::size_t i = 0; i < shape.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, apart(shape[i], shape[j]));
    return least;
}

} // namespace

TEST_CASE("in every shape nodes are at least a cell apart") {
    for (std::size_t count = 2; count <= 60; ++count) {
        CAPTURE(count);
        for (const Shape& shape :
             {row(count), column(count), snake(count, 8), rectangle(count), circle(count), star(count)}) {
            CHECK(shape.size() == count);
            CHECK(least_apart(shape) >= 1);
        }
    }
    for (std::size_t dimensions = 3; dimensions <= 7; ++dimensions)
        CHECK(least_apart(hypercube(dimensions)) >= 1);
    for (std::size_t dimensions = 3; dimensions <= 6; ++dimensions)
        CHECK(least_apart(cube_connected_cycles(dimensions)) >= 1);
    CHECK(least_apart(tree({no_node, 0, 0, 1, 1, 2, 2, 2, 3})) >= 1);
    CHECK(least_apart(grid({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}})) >= 1);
}

TEST_CASE("the cycles of cube-connected cycles do not overlap") {
    for (std::size_t dimensions = 3; dimensions <= 5; ++dimensions) {
        Shape shape = cube_connected_cycles(dimensions);
        std::vector<Box> cycles;
        for (std::size_t i = 0; i < shape.size(); i += dimensions) {
            const auto first = shape.begin() + static_cast<std::ptrdiff_t>(i);
            cycles.push_back(around(Shape(first, first + static_cast<std::ptrdiff_t>(dimensions))));
        }
        for (std::size_t i = 0; i < cycles.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK(!overlap(cycles[i], cycles[j]));
    }
}

TEST_CASE("a star has room in its centre") {
    for (std::size_t count = 3; count <= 40; ++count)
        for (picture::Point each : star(count))
            CHECK(apart(each, {}) >= 1);
}

TEST_CASE("neighbours in a line are neighbours in a snake") {
    Shape shape = snake(26, 8);
    for (std::size_t i = 0; i + 1 < shape.size(); ++i)
        CHECK(distance(shape[i], shape[i + 1]) == 1);
}

TEST_CASE("a four-dimensional hypercube is drawn as a torus: neighbours are adjacent or at opposite ends of a line") {
    Shape shape = hypercube(4);
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t bit = 1; bit < 16; bit *= 2) {
            double length = distance(shape[i], shape[i ^ bit]);
            CHECK((length == 1 || length == 3));
        }
}

TEST_CASE("a node of a tree stands above the middle of its children") {
    Shape shape = tree({no_node, 0, 0, 1, 1, 2, 2});
    CHECK(shape[0] == picture::Point{1.5, 0});
    CHECK(shape[1] == picture::Point{0.5, 1});
    CHECK(shape[6] == picture::Point{3, 2});
}
