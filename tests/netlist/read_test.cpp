// What good netlists come to.

#include "netlist/read.hpp"
#include "small_catalogue.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

Network good(const std::string& name, const Overrides& overrides = {}) {
    auto result = read_netlist(netlist_folder() + "/good/" + name, small_catalogue(), overrides);
    INFO(render(result.diagnostics));
    REQUIRE(result.network);
    return *result.network;
}

Network good_text(const std::string& text, const Overrides& overrides = {}) {
    auto result = read_netlist_text(text, small_catalogue(), overrides);
    INFO(render(result.diagnostics));
    REQUIRE(result.network);
    return *result.network;
}

const NetworkChannel& channel(const Network& network, const std::string& name) {
    for (const auto& candidate : network.channels)
        if (candidate.name == name)
            return candidate;
    FAIL("no channel " << name);
    throw 0;
}

/// The link that the channel leaves its sender by; -2 for a soft channel.
int sending_link(const Network& network, const NetworkChannel& at) {
    if (at.placement.kind == ChannelPlacement::Kind::soft)
        return -2;
    const auto& connection = network.connections[at.placement.connection];
    return (at.placement.from_a_to_b ? connection.a : connection.b).link;
}

} // namespace

TEST_CASE("four clusters of a master and three slaves") {
    auto network = good("clusters.cfs");
    CHECK(network.nodes.size() == 16 + 1 + 4); // processors, workstation, edges
    CHECK(network.connections.size() == 4 + 4 * 2 + 4 + 4 + 4);
    CHECK(network.processes.size() == 4 + 12 + 4);
    CHECK(network.nodes[4].name == "slave[0][0]");
    CHECK(network.nodes[4].type == "T800");
    CHECK(network.nodes[4].integer("memory") == 2 * 1024 * 1024);
    CHECK(network.nodes[4].integer("clock") == 20'000'000);
    CHECK(network.nodes[16].kind->name == "workstation");
    const auto& master = network.processes[3];
    CHECK(master.name == "breeder[3]");
    CHECK(master.high_priority);
    CHECK(master.parameters == std::map<std::string, Value>{{"population", std::int64_t{30}},
                                                            {"mutation", 0.01},
                                                            {"code", std::string("gray")}});
    REQUIRE(master.ports.size() == 3);
    CHECK(master.ports[0].port == "in");
    CHECK(network.channels[master.ports[0].channel].name == "feed[3].out -> breeder[3].in");
    CHECK(network.nodes[network.channels[master.ports[0].channel].from.node].name == "sun");
    CHECK(network.processes[4].stand_in);
    CHECK(network.processes[4].kind == "worker.lku");
    const auto& ring =
        network.connections[channel(network, "breeder[0].out -> worker[0][0].in").placement.connection + 3];
    CHECK(ring.name == "ring[0]");
    CHECK(ring.metres == doctest::Approx(0.3));
}

TEST_CASE("a val is overridden from outside") {
    CHECK(good("cluster_of_n.cfs").nodes.size() == 4);
    auto alone = good("cluster_of_n.cfs", {{"slaves", "0"}});
    CHECK(alone.nodes.size() == 1);
    CHECK(channel(alone, "m.out -> s.in").placement.kind == ChannelPlacement::Kind::soft);
    CHECK(good("cluster_of_n.cfs", {{"slaves", "2 * 2 + 1"}}).nodes.size() == 6);
    // a later val sees the override, and so does a frequency
    CHECK(good_text("val a 1; val b a + 1; edge t[b];", {{"a", "4"}}).nodes.size() == 5);
    CHECK(good_text("val f 20M; T800 (clock = f) t;", {{"f", "25M"}}).nodes[0].integer("clock") == 25'000'000);
}

TEST_CASE("M means a million in a frequency and 1048576 elsewhere") {
    auto network = good_text("val m 2M; T800 (memory = m, clock = 17500k, linkspeed = m * 10) t;");
    CHECK(network.nodes[0].integer("memory") == 2 * 1024 * 1024);
    CHECK(network.nodes[0].integer("clock") == 17'500'000);
    CHECK(network.nodes[0].integer("linkspeed") == 20'000'000);
}

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

TEST_CASE("names live to the end of their block") {
    auto network =
        good_text("T800 t; rep i = 0 for 3 { val t_of_i i * 10; process (interface (int n)) p; p (n = t_of_i);"
                  "place p on t; use \"p.lku\" for p; } process p; use \"p.lku\" for p; place p on t;");
    REQUIRE(network.processes.size() == 4);
    CHECK(network.processes[0].name == "p");
    CHECK(network.processes[2].name == "p_3");
    CHECK(network.processes[2].parameters.at("n") == Value(std::int64_t{20}));
    CHECK(network.processes[3].name == "p_4");
    // a bare statement of an if belongs to the block around it
    CHECK(good_text("val one 1; if one == 1 T800 t; else T414 t; process p; place p on t;").nodes[0].type == "T800");
}

TEST_CASE("expressions") {
    auto integer = [](const std::string& expression) {
        auto network = good_text("val a {1, 2, {3}[0]}; T800 t; process (interface (int n)) p; place p on t; "
                                 "use \"p.lku\" for p; p (n = " +
                                 expression + ");");
        return std::get<std::int64_t>(network.processes[0].parameters.at("n"));
    };
    CHECK(integer("2 + 3 * 4") == 14);
    CHECK(integer("(2 + 3) * 4") == 20);
    CHECK(integer("10 - 4 - 3") == 3);
    CHECK(integer("-7 / 2") == -3);
    CHECK(integer("-7 % 2") == -1);
    CHECK(integer("1 < 2 == TRUE && !0") == 1);
    CHECK(integer("0 && 1 / 0") == 0); // the right side is not looked at
    CHECK(integer("1 || 1 / 0") == 1);
    CHECK(integer("0x1F") == 31);
    CHECK(integer("2k") == 2048);
    CHECK(integer("'a'") == 97);
    CHECK(integer("'\\n' + '\\x41' + '\\101'") == 10 + 65 + 65);
    CHECK(integer("(char) 42") == 42);
    CHECK(integer("(int) 2.9 + (int) 2.5f") == 4);
    CHECK(integer("a[0] + a[2]") == 4);
    CHECK(integer("\"abc\"[1]") == 98);
    CHECK(integer("\"abc\" == \"abc\"") == 1);
    CHECK(integer("1.5 > 1") == 1);
    CHECK(integer("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
}
