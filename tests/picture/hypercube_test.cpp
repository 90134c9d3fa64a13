#include "picture/hypercube.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

std::size_t count_in(const std::string& svg, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(part); at != svg.npos; at = svg.find(part, at + part.size()))
        ++found;
    return found;
}

std::string drawing_of(const DrawnHypercube& cube, const VertexLegend& legend = {}) {
    return draw_hypercubes("title", {cube}, 1, legend);
}

} // namespace

TEST_CASE("a hypercube has 2^n vertices, and a link wherever two differ in one bit") {
    for (std::size_t dimensions = 1; dimensions <= 4; ++dimensions) {
        const std::string svg = drawing_of({.title = "", .dimensions = dimensions});
        const std::size_t vertices = std::size_t{1} << dimensions;
        CHECK(count_in(svg, "<circle ") == vertices);
        CHECK(count_in(svg, "class=\"link\"") == vertices * dimensions / 2);
    }
    CHECK_THROWS_AS(drawing_of({.title = "", .dimensions = 0}), std::invalid_argument);
    CHECK_THROWS_WITH_AS(drawing_of({.title = "", .dimensions = 5}),
                         "a hypercube of 5 dimensions cannot be drawn, expected 1 to 4", std::invalid_argument);
}

TEST_CASE("each vertex has its number and its string of bits") {
    const std::string svg = drawing_of({.title = "", .dimensions = 3});
    for (const char* bits : {"000", "001", "010", "011", "100", "101", "110", "111"})
        CHECK(count_in(svg, ">" + std::string(bits) + "<") == 1);
    CHECK(count_in(svg, ">7<") == 1);
}

TEST_CASE("members, parents and offspring look different; other vertices are empty") {
    const std::string svg = drawing_of(
        {.title = "",
         .dimensions = 2,
         .vertices = {{0, VertexLook::member, "2 copies"}, {1, VertexLook::parent}, {2, VertexLook::offspring}}});
    for (const char* look : {"class=\"member\"", "class=\"parent\"", "class=\"offspring\"", "class=\"empty\""})
        CHECK(count_in(svg, look) == 1);
    CHECK(count_in(svg, ">2 copies<") == 1);
}

TEST_CASE("the links of the smaller cube between two parents are thick") {
    const DrawnHypercube apart{.title = "", .dimensions = 4, .spanned = {{0b0000, 0b0101}}};
    CHECK(count_in(drawing_of(apart), "spanned\"") == 4); // a square
    const DrawnHypercube opposite{.title = "", .dimensions = 3, .spanned = {{0b000, 0b111}}};
    CHECK(count_in(drawing_of(opposite), "spanned\"") == 12); // the whole cube
    const DrawnHypercube same{.title = "", .dimensions = 3, .spanned = {{0b001, 0b001}}};
    CHECK(count_in(drawing_of(same), "spanned\"") == 0);
}

TEST_CASE("a mutation is drawn as an arrow") {
    const std::string svg = drawing_of({.title = "", .dimensions = 3, .moves = {{0, 1}, {0, 7}}});
    CHECK(count_in(svg, "class=\"move\"") == 2);
    CHECK(count_in(svg, "url(#arrow)") == 2);
}

TEST_CASE("hypercubes stand in rows, each with its title and text lines") {
    const std::vector<DrawnHypercube> cubes{{.title = "first", .dimensions = 2, .lines = {"a < b"}},
                                            {.title = "second", .dimensions = 2},
                                            {.title = "third", .dimensions = 2}};
    const std::string side_by_side = draw_hypercubes("all", cubes, 3, {}),
                      in_rows = draw_hypercubes("all", cubes, 1, {});
    auto size_of = [](const std::string& svg) {
        const std::size_t width = svg.find("width=\"") + 7, height = svg.find("height=\"") + 8;
        return std::pair(std::stod(svg.substr(width)), std::stod(svg.substr(height)));
    };
    CHECK(size_of(side_by_side).first > size_of(in_rows).first);
    CHECK(size_of(side_by_side).second < size_of(in_rows).second);
    for (const char* text : {"all", "first", "second", "third", "a &lt; b"})
        CHECK(count_in(in_rows, ">" + std::string(text) + "<") >= 1);
}

TEST_CASE("the legend explains the looks of vertices") {
    const std::string svg = drawing_of({.title = "", .dimensions = 1}, {{VertexLook::parent, "a parent"}});
    CHECK(count_in(svg, ">a parent<") == 1);
    CHECK(count_in(svg, "class=\"parent\"") == 1);
}
