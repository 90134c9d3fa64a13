#include "picture/blocks.hpp"

#include "picture/arrange.hpp"
#include "picture/wiring.hpp"
#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace picture = placedpar::picture;
using namespace placedpar;
using picture::Block;
using picture::Shape;

namespace {

std::vector<Block> blocks_in(const std::string& text) {
    const Network network = picture::network_of(text);
    return picture::blocks_of(network, picture::Wiring(network));
}

/// Returns the best shape of the only block.
Shape only_shape(const std::string& text) {
    const std::vector<Block> blocks = blocks_in(text);
    REQUIRE(blocks.size() == 1);
    return blocks.front().shapes.front();
}

std::string single_chain(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += fmt::format("T800 n{};\n", i);
    for (int i = 0; i + 1 < count; ++i)
        text += fmt::format("connect n{}.link[1] to n{}.link[0];\n", i, i + 1);
    return text;
}

} // namespace

TEST_CASE("an array wired into a line is drawn as a row, or as a snake if it is long") {
    CHECK(only_shape(picture::chain(8)) == picture::row(8));
    CHECK(only_shape(picture::chain(9)) == picture::snake(9, 8));
}

TEST_CASE("a ring is drawn as a circle") {
    CHECK(only_shape(picture::ring(3)) == picture::circle(3));
    CHECK(only_shape(picture::ring(12)) == picture::circle(12));
}

TEST_CASE("an array with two subscripts is drawn as a grid") {
    const Shape shape = only_shape(picture::torus(3, 4));
    REQUIRE(shape.size() == 12);
    CHECK(shape[1] - shape[0] == picture::Point{1, 0}); // t[0][1] is to the right of t[0][0]
    CHECK(shape[4] - shape[0] == picture::Point{0, 1}); // t[1][0] is below t[0][0]
}

TEST_CASE("a hypercube is recognised by its wires") {
    CHECK(only_shape(picture::cube(3)) == picture::hypercube(3));
    CHECK(only_shape(picture::cube(4)) == picture::hypercube(4));
    CHECK(only_shape(picture::ring(8)) != picture::hypercube(3));
}

TEST_CASE("the nodes of a star stand around its centre") {
    std::string text = "T800 hub; T800 t[4];\n";
    for (int i = 0; i < 4; ++i)
        text += fmt::format("connect hub.link[{0}] to t[{0}].link[0];\n", i);
    const std::vector<Block> blocks = blocks_in(text);
    const auto array = std::ranges::find_if(blocks, [](const Block& block) { return block.nodes.size() == 4; });
    REQUIRE(array != blocks.end());
    CHECK(array->shapes.front() == picture::star(4));
}

TEST_CASE("an array wired into a tree is drawn as a tree") {
    std::string text = "T800 t[7];\n";
    for (int i = 1; i < 7; ++i)
        text += fmt::format("connect t[{}].link[{}] to t[{}].link[0];\n", (i - 1) / 2, 1 + (i - 1) % 2, i);
    CHECK(only_shape(text) == picture::tree({picture::no_node, 0, 0, 1, 1, 2, 2}));
}

TEST_CASE("single nodes in a line are one block, which begins at an end") {
    const std::vector<Block> blocks = blocks_in(single_chain(5));
    REQUIRE(blocks.size() == 1);
    CHECK(blocks.front().nodes == std::vector<std::size_t>{0, 1, 2, 3, 4});
    CHECK(blocks.front().shapes.front() == picture::row(5));
}

TEST_CASE("every node is in one block, and no shape lacks a node") {
    for (const std::string& text :
         {picture::torus(3, 3), picture::chain(5) + "T800 a, b; connect a.link[0] to b.link[0];",
          single_chain(4) + "T800 x[3][2]; rep i = 0 for 3 connect x[i][0].link[0] to x[i][1].link[0];",
          picture::random_tree(15, 2), picture::random_wiring(8, 5)}) {
        const Network network = picture::network_of(text);
        std::multiset<std::size_t> seen;
        for (const Block& block : picture::blocks_of(network, picture::Wiring(network))) {
            REQUIRE_FALSE(block.shapes.empty());
            for (const Shape& shape : block.shapes)
                CHECK(shape.size() == block.nodes.size());
            seen.insert(block.nodes.begin(), block.nodes.end());
        }
        CHECK(seen.size() == network.nodes.size());
        CHECK(std::set(seen.begin(), seen.end()).size() == network.nodes.size());
    }
}

TEST_CASE("each arranged node has its own cell") {
    for (const std::string& text :
         {picture::torus(3, 5), picture::random_tree(25, 7), picture::random_wiring(12, 7),
          picture::ring(11) + "T800 x[4]; rep i = 0 for 3 connect x[i].link[0] to x[i + 1].link[1];"}) {
        const Network network = picture::network_of(text);
        const std::vector<picture::Point> places = picture::arrange(network, picture::Wiring(network));
        REQUIRE(places.size() == network.nodes.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const picture::Point apart = places[i] - places[j];
                CHECK((std::abs(apart.x) > .99 || std::abs(apart.y) > .99));
            }
    }
}
