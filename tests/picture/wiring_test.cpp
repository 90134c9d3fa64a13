#include "picture/wiring.hpp"

#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace picture = placedpar::picture;
using namespace placedpar;
using picture::Span;

namespace {

const char* const switched = "T800 a, b; C004 s;\n"
                             "connect a.link[2] to s.link[5]; connect b.link[3] to s.link[7];\n"
                             "connect s.link[5] to s.link[7];";

} // namespace

TEST_CASE("a wire from link to link has one span, with the numbers of its links") {
    const std::vector<Span> spans =
        picture::spans_of(picture::network_of("T800 a, b; connect a.link[2] to b.link[3];"));
    REQUIRE(spans.size() == 1);
    CHECK(spans[0].from_label == "2");
    CHECK(spans[0].to_label == "3");
}

TEST_CASE("a wire through a switch has a span to it and one from it") {
    const Network network = picture::network_of(switched);
    REQUIRE(network.connections.size() == 1);
    const std::vector<Span> spans = picture::spans_of(network);
    REQUIRE(spans.size() == 2);
    const std::size_t s = picture::node_named(network, "s");
    CHECK(spans[0].to.node == s);
    CHECK(spans[1].from.node == s);
    CHECK(spans[0].to_label == "5");
    CHECK(spans[1].from_label == "7");
}

TEST_CASE("neighbours are symmetric, and a switch is a neighbour of the nodes that it connects") {
    const Network network = picture::network_of(switched);
    const picture::Wiring wiring(network);
    const std::size_t a = picture::node_named(network, "a"), b = picture::node_named(network, "b"),
                      s = picture::node_named(network, "s");
    CHECK(wiring.linked(a, s));
    CHECK(wiring.linked(s, a));
    CHECK_FALSE(wiring.linked(a, b));
    CHECK(wiring.neighbours(s).size() == 2);
}

TEST_CASE("two wires between two nodes count the neighbour twice") {
    const Network network =
        picture::network_of("T800 a, b; connect a.link[0] to b.link[0]; connect a.link[1] to b.link[1];");
    CHECK(picture::Wiring(network).neighbours(0) == std::vector<std::size_t>{1, 1});
}
