// A whole netlist, from its text to the network.

#include "netlist/kinds/device_kind.hpp"
#include "tests/netlist/good_networks.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

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
        network
            .connections[channel(network, "breeder[0].out -> worker[0][0].in").placement.route.front().connection + 3];
    CHECK(ring.name == "ring[0]");
    CHECK(ring.metres == doctest::Approx(0.3));
}

TEST_CASE("what a netlist declares is known even where it is refused") {
    auto declared = [](const std::string& text) { return read_netlist_text(text, small_catalogue()).declared; };
    CHECK(declared("T800 t[3]; edge e; process p[4], q;").processes == 5);
    CHECK(declared("T800 t[3]; edge e;").processors == 3);
    CHECK(declared("T800 t[3]; connect t[0].link[9] to t[3].link[0]; process p[4];").processes == 4);
}
