// Wires through switches, and what carries each channel.

#include "tests/netlist/good_networks.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

/// The link that the channel leaves its sender by; -2 for a soft channel.
int sending_link(const Network& network, const NetworkChannel& at) {
    if (at.placement.kind == ChannelPlacement::Kind::soft)
        return -2;
    const auto& connection = network.connections[at.placement.connection];
    return (at.placement.from_a_to_b ? connection.a : connection.b).link;
}

} // namespace

TEST_CASE("switches are followed to the processors at the ends") {
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
    CHECK(channel(network, "there").placement == ChannelPlacement{ChannelPlacement::Kind::link, 0, false, false});
    CHECK(channel(network, "back[1]").placement.from_a_to_b);
    CHECK(network.processes[0].parameters.at("weights[1][0]") == Value(std::int64_t{3}));
    CHECK(network.processes[0].parameters.at("name") == Value(std::string("a \"b\"\n")));
    CHECK(network.processes[0].parameters.at("least") == Value(std::numeric_limits<std::int64_t>::min()));
}

TEST_CASE("channels share out the links between neighbours") {
    auto network = good("shared.cfs");
    auto link = [&](int i) {
        return sending_link(
            network, channel(network, "pumps[" + std::to_string(i) + "].out -> sinks[" + std::to_string(i) + "].in"));
    };
    // the last one is placed on link 1; the others take the lighter link, of equals the lower
    CHECK(link(4) == 1);
    CHECK(link(0) == 0);
    CHECK(link(1) == 0);
    CHECK(link(2) == 1);
    CHECK(link(3) == 0);
    CHECK(channel(network, "pumps[0].out -> sinks[0].in").placement.shared);
    const auto& back = channel(network, "back_from.out -> back_to.in");
    CHECK(sending_link(network, back) == 0);
    CHECK_FALSE(back.placement.shared); // alone in its direction
}

TEST_CASE("channels at the edge") {
    auto network = good("edges.cfs");
    const auto& keys = channel(network, "from_host -> app.keys");
    CHECK(keys.from.at_edge());
    CHECK(network.nodes[keys.from.node].name == "host");
    CHECK(keys.placement.kind == ChannelPlacement::Kind::edge);
    CHECK(keys.placement.connection == 0);
    const auto& log = channel(network, "log_in -> app.log");
    CHECK(network.nodes[log.from.node].name == "far");
    CHECK(log.placement.connection == 1);
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
