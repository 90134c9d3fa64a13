// Tests the wires through switches, and the routes of channels.

#include "tests/netlist/good_networks.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

/// Returns the link by which the channel leaves its sender; -2 for a soft channel.
int sending_link(const Network& network, const NetworkChannel& at) {
    if (at.placement.kind == ChannelPlacement::Kind::soft)
        return -2;
    return begin_of(at.placement.route.front(), network.connections).link;
}

} // namespace

TEST_CASE("wires through switches connect the processors at their ends") {
    auto network = good("switch.cfs");
    REQUIRE(network.connections.size() == 2);
    const auto& through = network.connections[0];
    CHECK(network.nodes[through.a.node].name == "b");
    CHECK(network.nodes[through.b.node].name == "a");
    CHECK(through.a.link == 2);
    CHECK(through.b.link == 0);
    REQUIRE(through.switches() == 2);
    CHECK(network.nodes[through.crossings[0].node].name == "right");
    CHECK(through.crossings[0].from_link == 31);
    CHECK(through.crossings[1].to_link == 3);
    CHECK(through.metres == doctest::Approx(0.6));
    CHECK(through.bits_per_second == 10'000'000);
    CHECK(channel(network, "there").placement == ChannelPlacement{ChannelPlacement::Kind::link, {{0, false}}, false});
    CHECK(channel(network, "back[1]").placement.route.front().from_a_to_b);
    CHECK(network.processes[0].parameters.at("weights[1][0]") == Value(std::int64_t{3}));
    CHECK(network.processes[0].parameters.at("name") == Value(std::string("a \"b\"\n")));
    CHECK(network.processes[0].parameters.at("least") == Value(std::numeric_limits<std::int64_t>::min()));
}

TEST_CASE("channels between neighbours are spread over their links") {
    auto network = good("shared.cfs");
    auto link = [&](int i) {
        return sending_link(
            network, channel(network, "pumps[" + std::to_string(i) + "].out -> sinks[" + std::to_string(i) + "].in"));
    };
    // The last channel is placed on link 1. The others take the link with fewer channels, or the lower link if both
    // carry equally many.
    CHECK(link(4) == 1);
    CHECK(link(0) == 0);
    CHECK(link(1) == 0);
    CHECK(link(2) == 1);
    CHECK(link(3) == 0);
    CHECK(channel(network, "pumps[0].out -> sinks[0].in").placement.in_packets);
    const auto& back = channel(network, "back_from.out -> back_to.in");
    CHECK(sending_link(network, back) == 0);
    CHECK_FALSE(back.placement.in_packets); // the only channel in its direction
}

TEST_CASE("channels at an edge are placed on links to the edge") {
    auto network = good("edges.cfs");
    const auto& keys = channel(network, "from_host -> app.keys");
    CHECK(keys.from.at_edge());
    CHECK(network.nodes[keys.from.node].name == "host");
    CHECK(keys.placement.kind == ChannelPlacement::Kind::edge);
    CHECK(keys.placement.route.front().connection == 0);
    const auto& log = channel(network, "log_in -> app.log");
    CHECK(network.nodes[log.from.node].name == "far");
    CHECK(log.placement.route.front().connection == 1);
    CHECK(channel(network, "app.trace[1] -> echo[1].in").placement.kind == ChannelPlacement::Kind::soft);
    CHECK(network.nodes[channel(network, "app.screen -> to_host").to.node].name == "host"); // the lower link
    CHECK(network.processes[0].other.at("location.code") == Value(std::int64_t{5}));
}

TEST_CASE("a channel placed on a link to an edge needs no edge channel") {
    auto network =
        good_text("T800 t; connect t.link[1] to host; process (interface (output out)) p; use \"p.lku\" for p;"
                  "place p on t; place p.out on t.link[1];");
    REQUIRE(network.channels.size() == 1);
    CHECK(network.channels[0].name == "p.out -> host");
    CHECK(network.channels[0].placement.kind == ChannelPlacement::Kind::edge);
}

namespace {

/// Returns the links by which the channel leaves each processor on its route.
std::string route_of(const Network& network, std::size_t channel = 0) {
    std::string text;
    for (const RouteHop& hop : network.channels[channel].placement.route)
        text += (text.empty() ? "" : " ") + link_name(network.nodes, begin_of(hop, network.connections));
    return text;
}

/// A ring of four processors: link 2 of each is wired to link 1 of the next.
Network ring_of_four(const std::string& rest) {
    return good_text("connection c, w; T800 t[4]; rep i = 0 for 4 connect t[i].link[2] to t[(i + 1) % 4].link[1];"
                     "process p[2], q[2]; use \"pump\" for p; use \"sink\" for q; connect p[0].out to q[0].in by c;"
                     "connect p[1].out to q[1].in; rep i = 0 for 2 place p[i] on t[0];" +
                     rest);
}

} // namespace

TEST_CASE("a channel between processors that are not neighbours takes the shortest route") {
    CHECK(route_of(ring_of_four("place q[0] on t[1]; place q[1] on t[1];"), 1) == "t[0].link[2]");
    auto network = ring_of_four("place q[0] on t[2]; place q[1] on t[2];");
    CHECK(route_of(network, 0) == "t[0].link[1] t[3].link[1]"); // of equal routes, the route by the lowest link
    CHECK(route_of(network, 1) == "t[0].link[2] t[1].link[2]"); // the wires with fewer channels
    CHECK(network.channels[0].placement.in_packets);
}

TEST_CASE("a netlist can state routes: by cost, hop by hop, in part, or by a wire") {
    std::string across = "place q[0] on t[2]; place q[1] on t[0];";
    CHECK(route_of(ring_of_four(across + "place p[0].out on t[0].link[2];")) == "t[0].link[2] t[1].link[2]");
    CHECK(route_of(ring_of_four(across + "place q[0].in on t[2].link[1];")) == "t[0].link[2] t[1].link[2]");
    CHECK(route_of(ring_of_four(across + "place p[0].out on t[0].link[1]; place p[0].out on t[3].link[1];")) ==
          "t[0].link[1] t[3].link[1]");
    std::string next = "place q[0] on t[1]; place q[1] on t[0];";
    CHECK(route_of(ring_of_four(next)) == "t[0].link[2]");
    CHECK(route_of(ring_of_four(next + "place p[0].out on t[0].link[1];")) == "t[0].link[1] t[3].link[1] t[2].link[1]");
    CHECK(route_of(ring_of_four(next + "place q[0].in on t[1].link[2];")) == "t[0].link[1] t[3].link[1] t[2].link[1]");
    auto by_cost =
        good_text("T800 t[3]; T800 (routecost = 5) slow; rep i = 0 for 2 connect t[i].link[2] to t[i + 1].link[1];"
                  "connect t[0].link[0] to slow.link[0]; connect slow.link[1] to t[2].link[3];"
                  "process p, q; use \"pump\" for p; use \"sink\" for q; connect p.out to q.in; place p on t[0]; place "
                  "q on t[2];");
    CHECK(route_of(by_cost) == "t[0].link[2] t[1].link[2]");
}

TEST_CASE("a linkquota keeps channels from passing through a processor or its higher links") {
    auto route_with = [](const std::string& quota, const std::string& from, const std::string& to) {
        // Routes lead from hub to each of three processors, and by a detour through `far`.
        return route_of(good_text("T800 (linkquota = " + quota + ") hub; T800 a, b, c, far;" +
                                  "connect hub.link[0] to a.link[0]; connect hub.link[1] to b.link[0];"
                                  "connect hub.link[3] to c.link[0]; connect a.link[1] to far.link[0];"
                                  "connect b.link[1] to far.link[1]; connect far.link[2] to c.link[1];"
                                  "process p, q; use \"pump\" for p; use \"sink\" for q; connect p.out to q.in;"
                                  "place p on " +
                                  from + "; place q on " + to + ";"));
    };
    const std::string by_far = "a.link[1] far.link[2]", by_hub = "a.link[0] hub.link[3]";
    CHECK(route_with("4", "a", "c") == by_hub);
    CHECK(route_with("3", "a", "c") == by_hub);
    CHECK(route_with("2", "a", "c") == by_far); // the third wired link exceeds the quota
    CHECK(route_with("2", "a", "b") == "a.link[0] hub.link[1]");
    CHECK(route_with("2", "c", "a") == "c.link[1] far.link[0]");
    for (const char* none : {"1", "0"}) {
        CHECK(route_with(none, "a", "b") == "a.link[1] far.link[1]");
        CHECK(route_with(none, "hub", "c") == "hub.link[3]"); // its own channels may take any link
        CHECK(route_with(none, "c", "hub") == "c.link[0]");
        CHECK(route_with(none, "hub", "far") == "hub.link[0] a.link[1]");
    }
}

TEST_CASE("a tolerance gives a warning if a channel passes through a processor, since the INMOS tool may choose "
          "another route") {
    auto said_with = [](const std::string& to) {
        return render(read_netlist_text("T800 a, b; T800 (tolerance = 3) c; connect a.link[0] to b.link[0];"
                                        "connect b.link[1] to c.link[0]; process p, q; use \"pump\" for p;"
                                        "use \"sink\" for q; connect p.out to q.in; place p on a; place q on " +
                                            to + ";",
                                        small_catalogue(), {}, "n.cfs"));
    };
    CHECK(said_with("b").empty());
    CHECK(
        said_with("c").starts_with("n.cfs:1:33: warning: the attribute \"tolerance\" has no effect on the route of the "
                                   "channel \"p.out -> q.in\"\n"));
}

TEST_CASE("packets that need more than a processor's stated memory give a warning at each processor of the route") {
    auto said_with = [](int channels, const std::string& memory) {
        const std::string n = std::to_string(channels);
        return render(read_netlist_text("T800 " + memory +
                                            " a, b, c; connect a.link[0] to b.link[0]; connect b.link[1] to c.link[0];"
                                            "process p[" +
                                            n + "], q[" + n +
                                            "]; use \"pump\" for p; use \"sink\" for q;"
                                            "rep i = 0 for " +
                                            n + " { connect p[i].out to q[i].in; place p[i] on a; place q[i] on c; }",
                                        small_catalogue(), {}, "n.cfs"));
    };
    CHECK(said_with(7, "(memory = 8K)").empty());
    CHECK(said_with(8, "").empty());
    CHECK(said_with(3, "(memory = 4K)").empty());
    CHECK(said_with(4, "(memory = 4K)").find("\"b\" has 4096 bytes of memory") != std::string::npos);
    std::string said = said_with(8, "(memory = 8K)"); // 4 packets of 260 bytes each, in 8192 bytes
    for (const char* node : {"a", "b", "c"})
        CHECK(
            said.find("warning: \"" + std::string(node) +
                      "\" has 8192 bytes of memory, but the packets of the channels that end at it or pass through it "
                      "need 8320 bytes (8 channels)\n") != std::string::npos);
}

TEST_CASE("a channel placed on a wire uses that wire") {
    auto network =
        good_text("connection c, w; T800 t[4]; rep i = 0 for 3 connect t[i].link[2] to t[i + 1].link[1];"
                  "connect t[3].link[2] to t[0].link[1] by w; process p, q; use \"pump\" for p; use \"sink\" for q;"
                  "connect p.out to q.in by c; place p on t[0]; place q on t[1]; place c on w;");
    CHECK(route_of(network) == "t[0].link[1] t[3].link[1] t[2].link[1]");
}
