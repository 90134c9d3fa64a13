// Tests which tracks a trace has, and their order.

#include "on_one_node.hpp"

#include "observe/trace/tracks.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;
using test::on_one_node;

namespace {

std::vector<std::string> names_of(const Tracks& tracks) {
    std::vector<std::string> names;
    for (std::size_t track : tracks.drawn())
        names.push_back(tracks.all()[track].name);
    return names;
}

/// Two nodes with a wire between their first links, and a process on each.
Network two_wired_nodes() {
    Network network = on_one_node({"p"});
    network.nodes.push_back(network.nodes.front());
    network.nodes.back().name = "u";
    network.processes.push_back(network.processes.front());
    network.processes.back().name = "q";
    network.processes.back().node = 1;
    LinkConnection wire;
    wire.a = {0, 0};
    wire.b = {1, 0};
    network.connections.push_back(wire);
    return network;
}

} // namespace

TEST_CASE("a node's tracks are its processor, its processes and its outgoing links, in this order") {
    Tracks tracks(two_wired_nodes());
    CHECK(names_of(tracks) ==
          std::vector<std::string>{"t", "p", "t.link[0] -> u.link[0]", "u", "q", "u.link[0] -> t.link[0]"});
}

TEST_CASE("a device's own tracks follow all others") {
    Network network = two_wired_nodes();
    DeviceKind kind = *network.nodes[1].kind;
    kind.executes = Execution::none;
    kind.tracks = [](const Network& all, std::size_t node) {
        return std::vector<std::string>{all.nodes[node].name, all.nodes[node].name + " waits"};
    };
    network.nodes[1].kind = std::make_shared<const DeviceKind>(kind);
    Tracks tracks(network);
    CHECK(names_of(tracks) ==
          std::vector<std::string>{"t", "p", "t.link[0] -> u.link[0]", "q", "u.link[0] -> t.link[0]", "u", "u waits"});
    CHECK(tracks.all()[tracks.of_place("u waits")].place.kind == Track::Kind::bus);
}

TEST_CASE("tracks of processors, links and buses are found by name, tracks of processes are not") {
    Tracks tracks(two_wired_nodes());
    for (const char* name : {"t", "u", "t.link[0] -> u.link[0]", "u.link[0] -> t.link[0]"}) {
        REQUIRE(tracks.of_place(name) != Tracks::none);
        CHECK(tracks.all()[tracks.of_place(name)].name == name);
    }
    CHECK(tracks.of_place("p") == Tracks::none);
    CHECK(tracks.of_place("") == Tracks::none);
}

TEST_CASE("a netlist's process has its track from the beginning, a machine's process from its first event") {
    Tracks tracks(on_one_node({"p"}));
    Simulation simulation;
    hardware::Processor& t = simulation.add<hardware::Processor>("t", 1'000'000'000);
    Process& p = simulation.process(
        "p", [] {}, &t);
    Process& router = simulation.process(
        "router of t", [] {}, &t);
    Process& nowhere = simulation.process("nowhere", [] {});
    CHECK(tracks.all().size() == 2);
    CHECK(tracks.all()[tracks.of(p)].name == "p");
    std::size_t made = tracks.of(router);
    CHECK(tracks.all()[made].place.kind == Track::Kind::machine_process);
    CHECK(tracks.of(router) == made);
    CHECK(tracks.of(nowhere) == Tracks::none);
    CHECK(tracks.all().size() == 3);
    simulation.run();
}
