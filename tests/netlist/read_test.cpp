// Reads a whole netlist, from its text to the network.

#include "netlist/kinds/device_kind.hpp"
#include "netlist/print/print.hpp"
#include "tests/netlist/good_networks.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

using namespace placedpar;

TEST_CASE("a netlist of four clusters gives four masters with three slaves each") {
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

TEST_CASE("a parsed netlist gives all its networks even if its files change") {
    const auto folder = std::filesystem::temp_directory_path() / ("placedpar-parsed-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    const auto main = folder / "clusters.cfs", included = folder / "clusters.inc";
    std::filesystem::copy_file(netlist_folder() + "/good/clusters.cfs", included);
    std::ofstream(main) << "#include \"clusters.inc\"\n";
    const std::vector<Overrides> settings{
        {}, {{"clusters", "2"}}, {{"slaves", "1"}}, {{"slavs", "1"}}, {{"linkspeed", "10M"}}, {}};
    auto said = [](const ReadResult& result) {
        return render(result) +
               (result.network ? print_cfs(*result.network) + result.network->included_paths.at(0) : "");
    };
    std::vector<std::string> expected;
    for (const Overrides& set : settings)
        expected.push_back(said(read_netlist(main, small_catalogue(), set)));
    const ParsedNetlist parsed(main);
    std::filesystem::remove_all(folder);
    for (std::size_t i = 0; i < settings.size(); ++i)
        CHECK(said(parsed.read(small_catalogue(), settings[i])) == expected[i]);
    CHECK(expected[0] != expected[1]);
}

TEST_CASE("the declarations of a refused netlist are known") {
    auto declared = [](const std::string& text) { return read_netlist_text(text, small_catalogue()).declared; };
    CHECK(declared("T800 t[3]; edge e; process p[4], q;").processes == 5);
    CHECK(declared("T800 t[3]; edge e;").processors == 3);
    CHECK(declared("T800 t[3]; connect t[0].link[9] to t[3].link[0]; process p[4];").processes == 4);
}
