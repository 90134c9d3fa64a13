#include "picture/software.hpp"

#include "picture/picture.hpp"
#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <string>

namespace picture = placedpar::picture;
using namespace placedpar;
using picture::Software;

namespace {

/// Processes that pass on their input, in a line over the nodes of a chain.
std::string pipeline() {
    return picture::chain(2) + "process p, a, c; use \"csp.producer\" for p; use \"csp.identity\" for a; "
                               "use \"csp.consumer\" for c; place p on t[0]; place a on t[1]; place c on t[1];\n"
                               "connect p.out to a.in; connect a.out to c.in;";
}

} // namespace

TEST_CASE("each process is a node with its kind and placement") {
    const Software software = picture::software_of(picture::network_of(pipeline()));
    REQUIRE(software.network.nodes.size() == 3);
    const std::size_t a = picture::node_named(software.network, "a");
    CHECK(software.network.nodes[a].type == "csp.identity");
    CHECK(std::get<std::string>(software.network.nodes[a].attributes.at("on")) == "t[1]");
}

TEST_CASE("channels are drawn as wires with their output ports") {
    const Software software = picture::software_of(picture::network_of(pipeline()));
    CHECK(software.network.connections.size() == 2); // one over the link, one within t[1]
    REQUIRE(software.spans.size() == 2);
    for (const picture::Span& span : software.spans)
        CHECK(span.from_label + span.to_label == "out");
}

TEST_CASE("all channels between two processes share one wire") {
    const Software software = picture::software_of(picture::network_of(
        "T800 t; process a, b; use \"csp.identity\" for a; use \"csp.identity\" for b; place a on t; place b on t;\n"
        "connect a.out to b.in; connect b.out to a.in;"));
    CHECK(software.network.connections.size() == 1);
    REQUIRE(software.spans.size() == 1);
    CHECK(software.spans[0].from_label == "out");
    CHECK(software.spans[0].to_label == "out");
}

TEST_CASE("an edge with channels is a node") {
    const Software software = picture::software_of(picture::network_of(
        "T800 t; edge e; connect t.link[0] to e; process p; use \"csp.producer\" for p; place p on t;\n"
        "output o; place o on e; connect p.out to o;"));
    CHECK(software.network.nodes.size() == 2);
    CHECK(picture::node_named(software.network, "e") == 1);
}

TEST_CASE("the processes of a tree stand below their parents; a line is arranged freely") {
    CHECK(picture::software_of(picture::network_of(pipeline())).places.empty());
    const Network network = picture::network_of(
        "T800 t; process p, d, c, e; use \"csp.producer\" for p; use \"csp.delta\" for d; use \"csp.consumer\" for c; "
        "use \"csp.consumer\" for e; place p on t; place d on t; place c on t; place e on t;\n"
        "connect p.out to d.in; connect d.out[0] to c.in; connect d.out[1] to e.in;");
    const Software software = picture::software_of(network);
    REQUIRE(software.places.size() == 4);
    auto place = [&](const char* name) { return software.places[picture::node_named(software.network, name)]; };
    CHECK(place("d").y == place("p").y + 1);
    CHECK(place("c").y == place("d").y + 1);
    CHECK(place("c").y == place("e").y);
    const picture::Picture drawn = picture::draw(software.network, software.spans, software.places);
    CHECK(drawn.wires.size() == 3);
}
