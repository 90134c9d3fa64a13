// Tests the boxes of nodes: their texts, their sizes and their places.

#include "picture/boxes.hpp"

#include "picture/arrange.hpp"
#include "picture/routes.hpp"
#include "picture/wiring.hpp"
#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace placedpar::picture {

namespace {

std::vector<DrawnNode> boxes_at(const std::string& netlist, const std::vector<Point>& places) {
    const Network network = network_of(netlist);
    return draw_nodes(network, spans_of(network), places);
}

DrawnNode only_box(const std::string& netlist) { return boxes_at(netlist, {{0, 0}}).at(0); }

/// Returns a netlist with this many processes on one node.
std::string crowded(int count) {
    return fmt::format("T800 t; process p[{0}]; rep i = 0 for {0} place p[i] on t;", count);
}

/// Returns the places of the nodes as the drawing arranges them, in cells.
std::vector<Point> arranged(const std::string& netlist) {
    const Network network = network_of(netlist);
    return arrange(network, Wiring(network));
}

bool on_raster(double length) { return std::abs(length / pitch - std::round(length / pitch)) < 1e-9; }

} // namespace

TEST_CASE("a text is wider the more letters it has, the larger and the bolder they are") {
    CHECK(width_of("", 10) == 0);
    CHECK(width_of("nn", 10) == 2 * width_of("n", 10));
    CHECK(width_of("n", 20) == 2 * width_of("n", 10));
    CHECK(width_of("n", 10, true) > width_of("n", 10));
}

TEST_CASE("a box states the node's type, memory and clock; an edge has no facts") {
    const std::string facts = only_box("T414 (memory = 2M, clock = 15M) t;").facts;
    CHECK(facts.starts_with("T414, "));
    CHECK(facts.find("15 MHz") != std::string::npos);
    CHECK(facts.find("2 M") != std::string::npos);
    CHECK(only_box("edge screen;").facts == "");
}

TEST_CASE("a process of high priority has a mark, and one without a program says so") {
    const DrawnNode node = only_box("T800 t; process (priority = HIGH) p; process q; place p on t; place q on t;");
    REQUIRE(node.processes.size() == 2);
    CHECK(node.processes[0].name == "p !");
    CHECK(node.processes[1].name == "q");
    CHECK(node.processes[1].kind == "no program");
}

TEST_CASE("the kind of a process is shown without its folder, and cut between characters if it is long") {
    const auto kind = [](const std::string& program) {
        return only_box("T800 t; process p; use \"" + program + "\" for p; place p on t;").processes.at(0).kind;
    };
    CHECK(kind("long/path/to/farm.lku") == "farm.lku");
    CHECK(kind(std::string(26, 'n')) == std::string(26, 'n'));
    CHECK(kind(std::string(27, 'n')) == std::string(24, 'n') + "..");
    std::string umlauts, cut;
    for (int i = 0; i < 20; ++i) // 40 bytes; an odd number of bytes precedes them
        umlauts += "ü";
    CHECK(kind("n" + umlauts).starts_with("nüü"));
    CHECK(kind("n" + umlauts).ends_with("ü.."));
}

TEST_CASE("processes stand in columns of eight, without overlap and inside the box") {
    for (int count : {1, 8, 9, 25}) {
        CAPTURE(count);
        const DrawnNode node = only_box(crowded(count));
        REQUIRE(node.processes.size() == static_cast<std::size_t>(count));
        std::vector<Box> lines;
        for (const ProcessLine& line : node.processes) {
            const double width = line.kind_at - line.at.x;
            CHECK(width >= width_of(line.name, process_size) + width_of(line.kind, kind_size));
            lines.push_back({{line.at.x + width / 2, line.at.y - process_size / 2}, width, process_size});
            CHECK(line.at.x >= node.box.left());
            CHECK(line.kind_at <= node.box.right());
            CHECK(line.at.y <= node.box.bottom());
        }
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK_FALSE(overlap(lines[i], lines[j]));
    }
    CHECK(only_box(crowded(9)).box.height == only_box(crowded(8)).box.height);
    CHECK(only_box(crowded(9)).box.width > only_box(crowded(8)).box.width);
}

TEST_CASE("borders lie on the raster, so that wires can begin there") {
    for (const DrawnNode& node : boxes_at(chain(3), {{0, 0}, {0.5, 1}, {2, 3}})) {
        CHECK(on_raster(node.box.left()));
        CHECK(on_raster(node.box.right()));
        CHECK(on_raster(node.box.top()));
        CHECK(on_raster(node.box.bottom()));
    }
}

TEST_CASE("nodes in one row or column have one centre line, and boxes in neighbouring cells do not touch") {
    const auto nodes = boxes_at(torus(2, 2), {{0, 0}, {1, 0}, {0, 1}, {1, 1}});
    CHECK(nodes[0].box.centre.y == nodes[1].box.centre.y);
    CHECK(nodes[0].box.centre.x == nodes[2].box.centre.x);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE(overlap(grown(nodes[i].box, 16), grown(nodes[j].box, 16)));
}

TEST_CASE("a node of many wires has sides with a distance of two pitches for each third of its wires") {
    const Network network = network_of(chain(2));
    const std::vector<Span> many(30, spans_of(network).front());
    const Box crowded = draw_nodes(network, many, {{0, 0}, {1, 0}})[0].box;
    CHECK(crowded.width >= 30. / 3 * 2 * pitch);
    CHECK(crowded.height >= 30. / 3 * 2 * pitch);
    CHECK(boxes_at(chain(2), {{0, 0}, {1, 0}})[0].box.height < crowded.height);
}

TEST_CASE("a network without nodes has neither boxes nor places") {
    CHECK(boxes_at("", {}).empty());
    CHECK(arranged("").empty());
}

TEST_CASE("a host stands above or to the left of the transputers that it serves") {
    const auto places = arranged("workstation sun; T800 t[3]; connect sun.link[0] to t[0].link[0];\n"
                                 "rep i = 0 for 2 connect t[i].link[1] to t[i + 1].link[2];");
    const Point host = places.at(0), first = places.at(1);
    CHECK(host.x <= first.x);
    CHECK(host.y <= first.y);
}

TEST_CASE("networks that no wire joins stand apart from each other") {
    const auto places = arranged(chain(4) + " T800 u[4]; rep i = 0 for 3 connect u[i].link[1] to u[i + 1].link[0];");
    const Box one = around(std::vector<Point>(places.begin(), places.begin() + 4)),
              other = around(std::vector<Point>(places.begin() + 4, places.end()));
    CHECK_FALSE(overlap(grown(one, 0.5), grown(other, 0.5)));
}

TEST_CASE("a count in both directions is as wide as its digits and arrows; a direction without channels has no room") {
    CHECK(width_of_count(1, 1) > width_of_count(1, 0) + digit_width + arrow_width);
    CHECK(width_of_count(10, 0) - width_of_count(1, 0) == doctest::Approx(digit_width));
    CHECK(width_of_count(3, 0) == width_of_count(0, 3));
}

} // namespace placedpar::picture
