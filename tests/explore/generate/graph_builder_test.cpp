// Tests the limits of a graph while it is read, and which files are graphs.

#include "explore/generate/graph.hpp"
#include "explore/generate/graph_topology.hpp"
#include "text/refused_text.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>

using namespace placedpar;
using namespace placedpar::generate;

namespace {

std::shared_ptr<const SourceFile> graph_file() { return std::make_shared<const SourceFile>("g.dot", "a\nb\nc\n"); }

} // namespace

TEST_CASE("a node is added at its first mention only, and keeps the line of this mention") {
    GraphBuilder builder(graph_file());
    CHECK_FALSE(builder.has("a"));
    CHECK(builder.node("a", 1) == 0);
    CHECK(builder.node("b", 2) == 1);
    CHECK(builder.node("a", 3) == 0);
    CHECK(builder.has("a"));
    REQUIRE(builder.graph().nodes.size() == 2);
    CHECK(builder.graph().nodes[0].line == 1);
    CHECK(builder.node("", 3) == 2); // the empty name is a name, too
}

TEST_CASE("an edge from a node to itself is refused with its line; two edges between two nodes are two wires") {
    GraphBuilder builder(graph_file());
    builder.node("a", 1);
    builder.node("b", 2);
    CHECK_THROWS_WITH_AS(builder.add_edge({.from = 1, .to = 1, .line = 3}),
                         doctest::Contains("g.dot:3:1: error: the edge leads from \"b\" to \"b\""), RefusedText);
    builder.add_edge({.from = 0, .to = 1, .line = 3});
    builder.add_edge({.from = 0, .to = 1, .line = 3});
    CHECK(builder.graph().edges.size() == 2);
}

TEST_CASE("nodes and edges together are limited") {
    GraphBuilder builder(graph_file());
    for (std::size_t i = 1; i < most_graph_elements; ++i)
        builder.node(std::to_string(i), 1);
    builder.add_edge({.from = 0, .to = 1, .line = 2});
    CHECK(builder.node("1", 3) == 0); // a known node takes no room
    CHECK_THROWS_WITH_AS(builder.node("new", 3), doctest::Contains("g.dot:3:1: error: the graph has more than 100000"),
                         RefusedText);
    CHECK_THROWS_AS(builder.add_edge({.from = 0, .to = 1, .line = 3}), RefusedText);
}

TEST_CASE("copied attributes are limited, and long attributes count more") {
    GraphBuilder builder(graph_file());
    const GraphAttributes short_one{{"clock", "20M"}}, long_one{{"label", std::string(100 * 1000, 'x')}};
    for (std::size_t i = 0; i < 999; ++i) // each counts 1 + 1000 times
        builder.count_copy(long_one, 1);
    builder.count_copy({}, 1); // nothing is copied
    for (std::size_t i = 999 * 1001; i < most_graph_attributes; ++i)
        builder.count_copy(short_one, 1);
    CHECK_THROWS_WITH_AS(builder.count_copy(short_one, 2),
                         doctest::Contains("g.dot:2:1: error: the defaults give the graph more than 1000000"),
                         RefusedText);
}

TEST_CASE("a refusal of the whole file shows no line") {
    CHECK_THROWS_WITH_AS(refuse_graph(graph_file(), 0, "it is empty", "add nodes"),
                         "g.dot: error: it is empty\nhint: add nodes\n", RefusedText);
    CHECK_THROWS_WITH_AS(refuse_graph(graph_file(), 2, "it is odd"), "g.dot:2:1: error: it is odd\n    b\n    ^\n",
                         RefusedText);
}

TEST_CASE("files with graphs are told from topologies by the ending of their names, in any case") {
    for (const char* name : {"a.graphml", "a.dot", "a.gv", "A.GraphML", "folder.d/B.DOT", "ring.gv"})
        CHECK(is_graph_file(name));
    for (const char* name : {"ring", "graphml", "dot", "a.dot.txt", "a.csv", "", ".", "a.graph"})
        CHECK_FALSE(is_graph_file(name));
}
