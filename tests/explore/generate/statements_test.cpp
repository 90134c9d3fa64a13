// Tests pieces of generated netlists, and distances between processors.

#include "explore/generate/statements.hpp"

#include "explore/generate/distances.hpp"
#include "explore/generate/generate.hpp"
#include "explore/problems.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

generate::Distances distances_of(const std::string& netlist) {
    ReadResult read = read_netlist_text(netlist, Catalogue());
    INFO(render(read));
    REQUIRE(read.network);
    return generate::distances_in(*read.network);
}

} // namespace

TEST_CASE("each loop indents its statements by one level; several statements have braces") {
    CHECK(generate::within({}, {"a;", "b;"}) == "a;\nb;\n");
    CHECK(generate::within({"rep i", "rep j"}, {"a;"}) == "rep i\n    rep j\n        a;\n");
    CHECK(generate::within({"rep i", "rep j"}, {"a;", "b;"}) == "rep i\n    rep j {\n        a;\n        b;\n    }\n");
}

TEST_CASE("a wire is connected by its links, and carries a channel each way between the ports of its ends") {
    generate::Topology pair;
    pair.wires = {{{"rep i = 0 for 3"}, {"[i]", "2", "i > 0"}, {"[i + 1]", "1", "0"}}};
    CHECK(generate::print_wires(pair) == "rep i = 0 for 3\n    connect t[i].link[2] to t[i + 1].link[1];\n");
    CHECK(generate::print_channels(pair, "island", "out", "in") ==
          "rep i = 0 for 3 {\n"
          "    connect island[i].out[i > 0] to island[i + 1].in[0];\n"
          "    connect island[i + 1].out[0] to island[i].in[i > 0];\n"
          "}\n");
}

TEST_CASE("distances count processors only, not the host and its wires") {
    const generate::Distances line = distances_of("workstation sun; T800 a, b, c; connect sun.link[0] to a.link[0];"
                                                  "connect a.link[1] to b.link[0]; connect b.link[1] to c.link[0];");
    CHECK(line.processors == 3);
    CHECK(line.links == 2);
    CHECK(line.degree == 2);
    CHECK(line.diameter == 2);
    CHECK(line.connected);
}

TEST_CASE("two wires between the same processors count twice but do not change distances") {
    const generate::Distances twice =
        distances_of("T800 a, b; connect a.link[0] to b.link[0]; connect a.link[1] to b.link[1];");
    CHECK(twice.links == 2);
    CHECK(twice.degree == 2);
    CHECK(twice.diameter == 1);
}

TEST_CASE("processors joined only by a host count as unconnected; the diameter is the larger part's diameter") {
    const generate::Distances apart =
        distances_of("workstation sun; T800 a, b, c; connect a.link[1] to b.link[0];"
                     "connect sun.link[0] to a.link[0]; connect sun.link[1] to c.link[0];");
    CHECK_FALSE(apart.connected);
    CHECK(apart.diameter == 1);
    CHECK(distances_of("T800 a;").connected);
}

TEST_CASE("a generated netlist begins with its description and the command that makes it again") {
    ProblemRegistry problems = known_problems(1);
    generate::TopologyRequest request;
    request.topology = "tree";
    request.size = "13";
    request.branches = 3;
    request.job = "farm";
    request.host = "node";
    const std::string text = generate::generate(request, known_kinds(problems)).text;
    CHECK(text.starts_with("/* A tree of 13, each with up to 3 children: 13 processors, 12 links between them, at "
                           "most 4 at one processor, diameter 4.\n   A farm: "));
    CHECK(text.find("\n   placedpar generate tree --size 13 --branches 3 --job farm --host node */\n") != text.npos);
    CHECK(text.find("\nplace host on t[0];\n") != text.npos);
}
