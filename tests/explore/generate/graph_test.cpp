// Tests the readers of graphs by files in the forms of networkx, yEd and Graphviz, and by hostile input.

#include "explore/generate/generate.hpp"
#include "explore/generate/graph.hpp"
#include "explore/generate/graph_topology.hpp"
#include "explore/problems.hpp"
#include "netlist/read.hpp"
#include "tests/scratch.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace placedpar;
using namespace placedpar::generate;

namespace {

std::string graph_path(const std::string& name) {
    return (std::filesystem::path(PLACEDPAR_SOURCE_DIR) / "tests/explore/generate/graphs" / name).string();
}

std::shared_ptr<const SourceFile> in_memory(const std::string& text) {
    return std::make_shared<const SourceFile>("graph", text);
}

Graph dot_of(const std::string& text) { return read_dot(in_memory(text)); }
Graph graphml_of(const std::string& text) { return read_graphml(in_memory(text)); }

std::string refusal_of(Graph (*read)(const std::string&), const std::string& text) {
    try {
        read(text);
        return "";
    } catch (const UserError& refused) {
        return refused.what();
    }
}

bool refuses(Graph (*read)(const std::string&), const std::string& text, const std::string& message) {
    return refusal_of(read, text).find(message) != std::string::npos;
}

std::string text_of_graph(const std::string& file, bool split = false) {
    const ProblemRegistry problems = known_problems(0);
    TopologyRequest request;
    request.topology = graph_path(file);
    request.split = split;
    return generate::generate(request, known_kinds(problems)).text;
}

Network network_of(const std::string& file, bool split = false) {
    const ProblemRegistry problems = known_problems(0);
    const Catalogue kinds = known_kinds(problems);
    ReadResult result = read_netlist_text(text_of_graph(file, split), kinds);
    REQUIRE(result.network.has_value());
    return std::move(*result.network);
}

Network network_from_text(const std::string& text) {
    const Scratch folder;
    return network_of(folder.write("graph.dot", text).string());
}

const LinkConnection& wire_between(const Network& network, const std::string& a, const std::string& b) {
    for (const LinkConnection& wire : network.connections)
        if (std::minmax(network.nodes[wire.a.node].name, network.nodes[wire.b.node].name) == std::minmax(a, b))
            return wire;
    throw std::runtime_error("no wire from " + a + " to " + b);
}

} // namespace

TEST_CASE("a file of networkx gives processors and wires with its attributes") {
    const Network network = network_of("networkx.graphml");
    REQUIRE(network.nodes.size() == 5); // with the workstation
    CHECK(network.nodes[0].integer("clock") == 25'000'000);
    CHECK(network.nodes[3].integer("clock") == 17'500'000);
    CHECK(network.nodes[3].integer("memory") == 4'194'304);
    CHECK(network.count_wires() == 5);
    CHECK(wire_between(network, "t[0]", "t[1]").bits_per_second == 10'000'000);
    CHECK(wire_between(network, "t[1]", "t[2]").bits_per_second == 20'000'000);
}

TEST_CASE("types that are not transputers, and speeds that contradict each other, are refused with their line") {
    auto refused = [](const std::string& text, const std::string& message) {
        const std::string path = (std::filesystem::temp_directory_path() / "placedpar_refused_graph.dot").string();
        std::ofstream(path) << text;
        TopologyRequest request;
        request.topology = path;
        CHECK_THROWS_WITH_AS(topology_of_graph(request, Catalogue()), doctest::Contains(message.c_str()), UserError);
        std::filesystem::remove(path);
    };
    for (const char* type : {"T8OO", "C004", "T400", "workstation"})
        refused(std::string("graph { a\nb [type=") + type + "]; a -- b }",
                "dot:2:1: error: the node \"b\" has the type \"" + std::string(type) + "\"");
    refused("digraph { a -> b [speed=10M]\nb -> a [speed=20M] }", "dot:2:1: error: speed is 20M here, but 10M");
    refused("graph { a -- b [speed=10M, linkspeed=20M] }", "the edge from a to b has both \"speed\" and \"linkspeed\"");
}

TEST_CASE("opposite edges of a directed graph are one wire") {
    CHECK(network_of("networkx-directed.graphml").count_wires() == 3); // with the host's
    CHECK(read_graphml(load_source(graph_path("networkx-directed.graphml")).file).edges.size() == 4);
}

TEST_CASE("a file of yEd gives the nodes inside its groups, with defaults and labels") {
    const Graph graph = read_graphml(load_source(graph_path("yed.graphml")).file);
    REQUIRE(graph.nodes.size() == 3);
    CHECK(graph.nodes[0].name == "n0::n0");
    CHECK(graph.nodes[0].attributes.at("label") == "master");
    CHECK(graph.nodes[1].attributes.at("label") == "left & right");
    CHECK(graph.nodes[0].attributes.at("clock") == "25000000");
    CHECK(graph.nodes[2].attributes.at("clock") == "20000000"); // the default
    const Network network = network_of("yed.graphml");
    CHECK(wire_between(network, "t[0]", "t[1]").bits_per_second == 10'000'000);
    CHECK(wire_between(network, "t[1]", "t[2]").bits_per_second == 20'000'000);
}

TEST_CASE("a graph by hand is the graph that Graphviz writes from it") {
    const Graph hand = read_dot(load_source(graph_path("hand.dot")).file),
                graphviz = read_dot(load_source(graph_path("graphviz.dot")).file);
    REQUIRE(hand.nodes.size() == 5);
    CHECK(hand.edges.size() == 5); // strict: the second edge from a to b is the first
    REQUIRE(graphviz.nodes.size() == hand.nodes.size());
    CHECK(graphviz.edges.size() == hand.edges.size());
    for (const GraphNode& node : hand.nodes) {
        const auto found = std::ranges::find(graphviz.nodes, node.name, &GraphNode::name);
        REQUIRE_MESSAGE(found != graphviz.nodes.end(), node.name);
        CHECK(found->attributes.contains("memory") == node.attributes.contains("memory"));
    }
    const Network network = network_of("hand.dot");
    CHECK(network.nodes[0].integer("clock") == 25'000'000);
    CHECK(network.nodes[1].integer("clock") == 20'000'000);
    CHECK(network.nodes[2].integer("memory") == 2 * 1024 * 1024);
    CHECK(wire_between(network, "t[0]", "t[1]").bits_per_second == 10'000'000);
    CHECK(wire_between(network, "t[3]", "t[4]").metres == 7.5);
}

TEST_CASE("edges to a subgraph lead to all its nodes, and its defaults end with it") {
    const Graph graph = dot_of("digraph { x -> { node [clock=1] a b } -> y; c }");
    CHECK(graph.nodes.size() == 5);
    CHECK(graph.edges.size() == 4);
    CHECK(graph.nodes[1].attributes.contains("clock"));
    CHECK_FALSE(graph.nodes[4].attributes.contains("clock"));
}

TEST_CASE("a node of more than four edges is refused by name, or split") {
    CHECK_THROWS_WITH_AS(network_of("star.graphml"),
                         doctest::Contains("a node has more than 4 edges: \"0\" (to 1, 2, 3, 4, 5)"), UserError);
    const Network network = network_of("star.graphml", true);
    CHECK(network.nodes.size() == 8);
    CHECK(network.count_wires() == 7); // five edges, the wire between the two processors, and the host's
    CHECK(wire_between(network, "t[0]", "t[6]").metres == 0);
}

TEST_CASE("an error in a graph is shown in the line of the wrong word") {
    const auto line_of = [](const std::string& text) {
        const std::string refusal = refusal_of(dot_of, text);
        return refusal.substr(0, refusal.find(": error"));
    };
    CHECK(line_of("graph {\n  a -- b;\n  b -- c\n  ] ;\n}\n") == "graph:4:1");
    CHECK(line_of("graph {\n  a [colour=\n]\n;\n}\n") == "graph:3:1");
    CHECK(line_of("graph {\n  a [\n=\n]\n}\n") == "graph:3:1");
    CHECK(line_of("graph {\n  a\n-> b\n}\n") == "graph:3:1");
    CHECK(line_of("chart\n\n{ }") == "graph:1:1");
    CHECK(line_of("graph { }\n\n}\n\n") == "graph:3:1");
    CHECK(line_of("graph {\n  \"a\n\n") == "graph:2:1");
}

TEST_CASE("two edges between two nodes are two wires for one channel in each direction") {
    const Network network = network_from_text("graph { a -- b; a -- b; b -- c }");
    CHECK(std::ranges::count_if(network.connections, [&](const LinkConnection& wire) {
              return network.nodes[wire.a.node].name == "t[0]" && network.nodes[wire.b.node].name == "t[1]";
          }) == 2);
    CHECK(network.channels.size() == 2 * 2 + 3); // between islands, and from each island to the host
}

TEST_CASE("a graph in several parts is refused with the nodes apart, and a wrong value with its range") {
    CHECK_THROWS_WITH_AS(network_from_text("graph { a -- b; c; d -- e }"),
                         doctest::Contains(".dot:1:1: error: no edges lead from \"a\" to \"c\", \"d\", \"e\""),
                         UserError);
    const auto refused = [](const std::string& attributes, const std::string& message) {
        CHECK_THROWS_WITH_AS(network_from_text("graph { a -- b [" + attributes + "] }"),
                             doctest::Contains(message.c_str()), UserError);
    };
    refused("length=-3", "length of the edge from a to b: \"-3\" is out of range\n");
    refused("length=-3", "expected from 0 to 1000 metres");
    refused("speed=\"2000M\"", "\"2000M\" is out of range");
    refused("speed=2.5", "\"2.5\" is not an integer");
    refused("length=nan", "\"nan\" is not a number");
    CHECK(wire_between(network_from_text("graph { a -- b [speed=\"1.5M\"] }"), "t[0]", "t[1]").bits_per_second ==
          1'500'000);
}

TEST_CASE("hostile graphs are refused in words") {
    std::string deep = "graph ";
    for (int i = 0; i < 100'000; ++i)
        deep += "{";
    CHECK(refuses(dot_of, deep, "nested deeper than 64"));
    std::string nested = "<graphml>";
    for (int i = 0; i < 100'000; ++i)
        nested += "<a>";
    CHECK(refuses(graphml_of, nested, "nested deeper than 64"));
    CHECK(refuses(graphml_of, "<!DOCTYPE g [<!ENTITY a \"&b;&b;\">]><graphml><graph/></graphml>", "declares entities"));
    CHECK(refuses(graphml_of, "<graphml><graph><node id=\"&a;\"/></graph></graphml>", "undefined entity"));
    CHECK(refuses(graphml_of, "<graphml><graph><node id='&#x110000;'/></graph></graphml>",
                  "reference to invalid character number"));
    CHECK(refuses(graphml_of, "<graphml><graph></graphml>", "this is not well-formed XML: mismatched tag"));
    CHECK(refuses(graphml_of, "<graphml><graph>", "no element found"));
    CHECK(
        refuses(graphml_of, "<graphml><graph><edge source='a' target='b'/></graph></graphml>", "\"a\" is not a node"));
    CHECK(refuses(graphml_of, "<graphml><graph><hyperedge/></graph></graphml>", "<hyperedge>"));
    CHECK(refuses(graphml_of, "", "no element found"));
    CHECK(refuses(graphml_of, "<graphml/>", "no element <graph>"));
    CHECK(refuses(dot_of, "graph { a -- a }", "leads from \"a\" to \"a\""));
    CHECK(refuses(dot_of, "graph { \"a }", "a string is not closed"));
    CHECK(refuses(dot_of, "graph { /* a }", "a comment is not closed"));
    CHECK(refuses(dot_of, "graph { a [label=<<b> }", "is not closed"));
    CHECK(refuses(dot_of, "graph { a -- ", "\"}\" is missing"));
    CHECK(refuses(dot_of, "graph { a [=] }", "expected an attribute"));
    CHECK(refuses(dot_of, "graph { a - b }", "\"-\" is not expected here"));
    CHECK(refuses(dot_of, "graph { my-node }", "a name with \"-\" needs quotes"));
    CHECK(refuses(dot_of, "graph { a -> b }", "the edge of a graph is written \"->\""));
    CHECK(refuses(dot_of, "digraph { a -- b }", "the edge of a digraph is written \"--\""));
    CHECK(dot_of("graph { -1.5 -- -.5 }").nodes.size() == 2);
    CHECK(refuses(dot_of, "chart { }", "expected \"graph\" or \"digraph\""));
    CHECK(refuses(dot_of, "", "expected \"graph\" or \"digraph\""));
}

TEST_CASE("a graph that joins very many pairs is refused, not built") {
    std::string many = "strict graph { {";
    for (int i = 0; i < 2000; ++i)
        many += " a" + std::to_string(i);
    many += "} -- {";
    for (int i = 0; i < 2000; ++i)
        many += " b" + std::to_string(i);
    CHECK(refuses(dot_of, many + "} }", "more than 100000 nodes and edges"));
}

TEST_CASE("defaults that would be copied to very many nodes or edges are refused with the line") {
    std::string list, keys, many, elements;
    for (int i = 0; i < 1000; ++i) {
        const std::string number = std::to_string(i);
        list += "a" + number + "=1 ";
        keys += "<key id='k" + number + "' for='node' attr.name='a" + number + "'><default>1</default></key>";
    }
    for (int i = 0; i < 1001; ++i) {
        many += "n" + std::to_string(i) + "\n";
        elements += "<node id='" + std::to_string(i) + "'/>\n";
    }
    const std::string refused = "error: the defaults give the graph more than 1000000 attributes";
    CHECK(refuses(dot_of, "graph { node [" + list + "] " + many + "}", "graph:1001:1: " + refused));
    CHECK(refuses(dot_of, "graph { node [label=\"" + std::string(9'000'000, 'x') + "\"]\n" + many + "}",
                  "graph:13:1: " + refused));
    CHECK(refuses(dot_of, "graph { edge [" + list + "]\n{" + many + "} -- b }", refused));
    CHECK(refuses(dot_of, "graph { edge [" + list + "]\n" + std::string(4000, '{') + "}", "nested deeper than 64"));
    std::string subgraphs;
    for (int i = 0; i < 1001; ++i)
        subgraphs += "{}";
    CHECK(refuses(dot_of, "graph { edge [" + list + "]\n" + subgraphs + "}", "graph:2:1: " + refused));
    CHECK(refuses(graphml_of, "<graphml>" + keys + "<graph>" + elements + "</graph></graphml>",
                  "graph:1001:1: " + refused));
    CHECK(dot_of("graph { node [" + list + "] " + many.substr(0, 3000) + "}").nodes.size() > 600);
}

TEST_CASE("characters by number are read, in UTF-8") {
    CHECK(graphml_of("<graphml><graph><node id='&#65;&#xe9;&#x20ac;&#x1F600;'/></graph></graphml>").nodes.at(0).name ==
          "A\u00e9\u20ac\U0001F600");
    CHECK(graphml_of("<graphml><graph><node id='a>b'/></graph></graphml>").nodes.at(0).name == "a>b");
}
