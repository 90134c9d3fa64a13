// Tests properties of every drawing, with regular and with randomly wired networks.

#include "picture/picture.hpp"

#include "picture/large.hpp"
#include "picture/wiring.hpp"
#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace picture = placedpar::picture;
using namespace placedpar;
using picture::Box;
using picture::Picture;

namespace {

Picture picture_of(const Network& network) { return picture::draw(network, picture::spans_of(network)); }

/// Returns chains, rings, tori, cubes, trees and randomly wired networks.
std::vector<std::string> networks_to_draw() {
    std::vector<std::string> texts{"T800 alone;", picture::torus(3, 5), picture::torus(4, 4)};
    for (int count : {2, 3, 9, 17, 40}) {
        texts.push_back(picture::chain(count));
        if (count > 2)
            texts.push_back(picture::ring(count));
    }
    for (int dimensions : {2, 3, 4})
        texts.push_back(picture::cube(dimensions));
    for (unsigned seed = 1; seed <= 12; ++seed) {
        texts.push_back(picture::random_tree(3 + 2 * seed, seed));
        texts.push_back(picture::random_wiring(static_cast<int>(3 + seed), seed));
    }
    return texts;
}

void for_each_picture(const std::function<void(const Network&, const Picture&)>& check) {
    for (const std::string& text : networks_to_draw()) {
        CAPTURE(text);
        const Network network = picture::network_of(text);
        check(network, picture_of(network));
    }
}

/// Returns whether the point lies within a hundredth of a pixel of the box's border.
bool is_on_border(const Box& box, picture::Point p) {
    const double across = std::abs(p.x - box.centre.x) - box.width / 2,
                 down = std::abs(p.y - box.centre.y) - box.height / 2;
    return std::abs(std::max(across, down)) < .01;
}

std::vector<Box> labels_of(const Picture& drawn) {
    std::vector<Box> labels;
    for (const picture::DrawnWire& wire : drawn.wires) {
        for (const picture::LinkLabel& label : wire.links)
            labels.push_back(label.box);
        if (wire.channels)
            labels.push_back(wire.channels->box);
    }
    return labels;
}

/// Returns a ring, and a processor beside it that is wired to four of the ring's nodes.
std::string ring_with_neighbour(int count) {
    return picture::ring(count) + fmt::format(" T800 beside; rep i = 0 for 4 "
                                              "connect beside.link[i] to t[i * {}].link[2];",
                                              count / 4);
}

/// Returns the total number of points in the wires of the processor beside the ring.
std::size_t points_outside_of_ring(int count) {
    const Picture drawn = picture_of(picture::network_of(ring_with_neighbour(count)));
    std::size_t points = 0;
    for (const picture::DrawnWire& wire : std::span(drawn.wires).last(4))
        points += wire.spans.at(0).size();
    return points;
}

} // namespace

TEST_CASE("no two boxes overlap, and no label lies on a box or on another label") {
    for_each_picture([](const Network&, const Picture& drawn) {
        std::vector<Box> all = labels_of(drawn);
        for (const picture::DrawnNode& node : drawn.nodes)
            all.push_back(node.box);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK_FALSE(overlap(all[i], all[j]));
    });
}

TEST_CASE("every wire leads from the border of its first node to the border of its second") {
    for_each_picture([](const Network& network, const Picture& drawn) {
        REQUIRE(drawn.wires.size() == network.connections.size());
        for (std::size_t i = 0; i < drawn.wires.size(); ++i) {
            const LinkConnection& wire = network.connections[i];
            REQUIRE(drawn.wires[i].spans.size() == 1);
            const picture::Path& path = drawn.wires[i].spans.front();
            REQUIRE(path.size() >= 2);
            CHECK(is_on_border(drawn.nodes[wire.a.node].box, path.front()));
            CHECK(is_on_border(drawn.nodes[wire.b.node].box, path.back()));
        }
    });
}

TEST_CASE("no wire leads through the box of a node") {
    for_each_picture([](const Network&, const Picture& drawn) {
        for (const picture::DrawnWire& wire : drawn.wires)
            for (const picture::Path& path : wire.spans)
                for (std::size_t i = 0; i + 1 < path.size(); ++i)
                    for (const picture::DrawnNode& node : drawn.nodes)
                        CHECK_FALSE(crosses(grown(node.box, -.01), path[i], path[i + 1]));
    });
}

TEST_CASE("the extent contains everything drawn") {
    for_each_picture([](const Network&, const Picture& drawn) {
        const Box all = grown(extent_of(drawn), .01);
        for (const picture::DrawnNode& node : drawn.nodes) {
            CHECK(node.box.left() >= all.left());
            CHECK(node.box.bottom() <= all.bottom());
        }
        for (const picture::DrawnWire& wire : drawn.wires)
            for (const picture::Path& path : wire.spans)
                for (picture::Point p : path)
                    CHECK_FALSE(!overlap(all, {p, .02, .02}));
    });
}

TEST_CASE("the same network gives the same picture") {
    for (const std::string& text : {picture::random_wiring(9, 3), picture::random_tree(20, 3)}) {
        const Picture one = picture_of(picture::network_of(text)), other = picture_of(picture::network_of(text));
        for (std::size_t i = 0; i < one.nodes.size(); ++i)
            CHECK(one.nodes[i].box.centre == other.nodes[i].box.centre);
        for (std::size_t i = 0; i < one.wires.size(); ++i)
            CHECK(one.wires[i].spans == other.wires[i].spans);
    }
}

TEST_CASE("both ends of a wire have the number of their link") {
    const Network network = picture::network_of(picture::chain(3));
    const Picture drawn = picture_of(network);
    for (std::size_t i = 0; i < drawn.wires.size(); ++i) {
        const auto& links = drawn.wires[i].links;
        REQUIRE(links.size() == 2);
        std::vector<std::string> texts{links[0].text, links[1].text};
        std::ranges::sort(texts);
        CHECK(texts == std::vector<std::string>{"0", "1"});
        for (const picture::LinkLabel& label : links) { // the number is at its own end of the wire
            const bool at_a = label.text == std::to_string(network.connections[i].a.link);
            const picture::Path& path = drawn.wires[i].spans.front();
            const double to_a = distance(label.box.centre, path.front()),
                         to_b = distance(label.box.centre, path.back());
            CHECK((at_a ? to_a < to_b : to_b < to_a));
        }
    }
}

TEST_CASE("a wire is labelled with the number of channels in each direction") {
    const Network network =
        picture::network_of(picture::chain(2) + picture::stream("t[0]", "t[1]") +
                            "process q, d; use \"csp.producer\" for q; use \"csp.consumer\" for d;\n"
                            "place q on t[0]; place d on t[1]; connect q.out to d.in;");
    const Picture drawn = picture_of(network);
    REQUIRE(drawn.wires.front().channels);
    const picture::ChannelCount& count = *drawn.wires.front().channels;
    CHECK(count.onward + count.back == 2);
    const bool t0_is_first = drawn.nodes[0].box.centre.x < drawn.nodes[1].box.centre.x ||
                             drawn.nodes[0].box.centre.y < drawn.nodes[1].box.centre.y;
    CHECK((t0_is_first ? count.onward : count.back) == 2);
    CHECK(picture::width_of_count(2, 0) < picture::width_of_count(2, 2));
    CHECK(picture::width_of_count(2, 0) < picture::width_of_count(20, 0));
    CHECK_FALSE(picture_of(picture::network_of(picture::chain(2))).wires.front().channels);
}

TEST_CASE("a node's box has room for its processes, and states the number of channels inside") {
    const Network network = picture::network_of("T800 t; " + picture::stream("t", "t"));
    const picture::DrawnNode node = picture_of(network).nodes.front();
    CHECK(node.name == "t");
    CHECK(node.facts.starts_with("T800"));
    CHECK(node.inside == "1 channel inside");
    REQUIRE(node.processes.size() == 2);
    CHECK(node.processes[0].name == "p");
    CHECK(node.processes[1].kind == "csp.consumer");
    for (const picture::ProcessLine& line : node.processes) {
        CHECK(line.at.x >= node.box.left());
        CHECK(line.kind_at <= node.box.right());
        CHECK(line.at.y <= node.box.bottom());
        CHECK(line.at.x + picture::width_of(line.name, picture::process_size) <
              line.kind_at - picture::width_of(line.kind, picture::kind_size));
    }
}

TEST_CASE("a long name is cut short, and its box is no wider than its text") {
    const std::string name(60, 'n');
    const picture::DrawnNode node = picture_of(picture::network_of("T800 " + name + ";")).nodes.front();
    CHECK(node.name.size() == 26);
    CHECK(node.name.ends_with(".."));
    CHECK(picture::width_of(node.name, picture::name_size, true) <= node.box.width);
}

TEST_CASE("nodes of an array have boxes of one size") {
    const Network network = picture::network_of(picture::chain(4) + picture::stream("t[0]", "t[3]"));
    const Picture drawn = picture_of(network);
    for (const picture::DrawnNode& node : drawn.nodes) {
        CHECK(node.box.width == drawn.nodes[0].box.width);
        CHECK(node.box.height == drawn.nodes[0].box.height);
    }
}

TEST_CASE("given places are kept") {
    const Network network =
        picture::network_of("T800 a, b, c; connect a.link[0] to b.link[0]; connect b.link[1] to c.link[0];");
    const Picture drawn = picture::draw(network, {}, {{2, 0}, {0, 0}, {0, 3}});
    CHECK(drawn.nodes[1].box.centre.x < drawn.nodes[0].box.centre.x);
    CHECK(drawn.nodes[1].box.centre.y == drawn.nodes[0].box.centre.y);
    CHECK(drawn.nodes[1].box.centre.x == drawn.nodes[2].box.centre.x);
    CHECK(drawn.nodes[2].box.centre.y > drawn.nodes[1].box.centre.y);
}

TEST_CASE("in large networks no boxes overlap, and no wire leads through a box") {
    for (const std::string& text :
         {picture::torus(16, 16), picture::chain(250), picture::ring(210), ring_with_neighbour(220)}) {
        const Network network = picture::network_of(text);
        REQUIRE(network.nodes.size() >= picture::large_network);
        const Picture drawn = picture_of(network);
        for (std::size_t i = 0; i < drawn.nodes.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (overlap(drawn.nodes[i].box, drawn.nodes[j].box))
                    FAIL_CHECK(drawn.nodes[i].name << " lies on " << drawn.nodes[j].name);
        for (std::size_t i = 0; i < drawn.wires.size(); ++i) {
            const picture::Path& path = drawn.wires[i].spans.at(0);
            CHECK(is_on_border(drawn.nodes[network.connections[i].a.node].box, path.front()));
            CHECK(is_on_border(drawn.nodes[network.connections[i].b.node].box, path.back()));
            for (std::size_t k = 0; k + 1 < path.size(); ++k)
                for (const picture::DrawnNode& node : drawn.nodes)
                    if (crosses(grown(node.box, -.01), path[k], path[k + 1]))
                        FAIL_CHECK("wire " << i << " leads through " << node.name);
        }
    }
}

TEST_CASE("a wire around a ring of 16 times the size has 4 times the points") {
    const std::size_t small = points_outside_of_ring(200), large = points_outside_of_ring(3200);
    CHECK(small > 20);
    CHECK(large > 2 * small);
    CHECK(large < 5 * small);
}
