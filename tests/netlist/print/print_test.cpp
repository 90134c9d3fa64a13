// Tests that a printed network loads again as the same network.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <filesystem>

using namespace placedpar;

namespace {

/// Returns the network as JSON, which has all fields of the structures except places; leaves out the source's path.
std::string content(Network network) {
    network.source_path = "";
    return print_json(network);
}

void check_round_trip(const Network& network) {
    auto printed = print_cfs(network);
    auto again = read_netlist_text(printed, small_catalogue());
    INFO(printed);
    INFO(render(again.diagnostics));
    REQUIRE(again.network);
    CHECK(again.diagnostics.empty());
    CHECK(print_cfs(*again.network) == printed);
    CHECK(content(*again.network) == content(network));
    CHECK(again.network->hash == network.hash);
}

} // namespace

TEST_CASE("a printed network loads again as the same network") {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(netlist_folder() + "/good")) {
        if (entry.path().extension() != ".cfs")
            continue;
        CAPTURE(entry.path().filename().string());
        auto result = read_netlist(entry.path(), small_catalogue());
        INFO(render(result.diagnostics));
        REQUIRE(result.network);
        check_round_trip(*result.network);
        ++files;
    }
    CHECK(files >= 5);
}

TEST_CASE("a printed network loads again for every number of slaves") {
    for (int slaves = 0; slaves < 12; ++slaves) {
        auto result = read_netlist(netlist_folder() + "/good/cluster_of_n.cfs", small_catalogue(),
                                   {{"slaves", std::to_string(slaves)}});
        REQUIRE(result.network);
        check_round_trip(*result.network);
    }
}

TEST_CASE("elements of an array can differ in their attributes") {
    const std::string array = "T800 (clock = 25M) t[3]; connect t[0].link[0] to t[1].link[0];";
    const auto changed =
        read_netlist_text(array + "t[1] (clock = 20M, memory = 2M); t[2] (rank = 1);", small_catalogue());
    REQUIRE(changed.network);
    CHECK(changed.network->nodes[0].integer("clock") == 25'000'000);
    CHECK(changed.network->nodes[1].integer("clock") == 20'000'000); // the default of a T800, but not of the array
    CHECK(changed.network->nodes[1].integer("memory") == 2 << 20);
    check_round_trip(*changed.network);
    const auto set = read_netlist_text(array, small_catalogue(), {{"t[1].clock", "20M"}});
    REQUIRE(set.network);
    check_round_trip(*set.network);
    CHECK(set.network->hash != read_netlist_text(array, small_catalogue()).network.value().hash);
}

TEST_CASE("the hash depends on the network, not on the file") {
    auto hash = [](const std::string& text) { return read_netlist_text(text, small_catalogue()).network.value().hash; };
    CHECK(hash("T800 a, b; connect a.link[0] to b.link[0];") ==
          hash("val n 0; /* the same */ T800 (memory = 4k) a, b;\nconnect a.link[n], b.link[n];"));
    CHECK(hash("T800 a, b; connect a.link[0] to b.link[0];") != hash("T800 a, b; connect a.link[0] to b.link[1];"));
}

TEST_CASE("the JSON document has nodes, wires, processes and channels") {
    auto result = read_netlist(netlist_folder() + "/good/shared.cfs", small_catalogue());
    REQUIRE(result.network);
    auto document = boost::json::parse(print_json(*result.network)).as_object();
    std::vector<std::string> keys;
    for (const auto& pair : document)
        keys.emplace_back(pair.key());
    CHECK(keys == std::vector<std::string>{"source", "hash", "nodes", "connections", "processes", "channels"});
    const auto& channel = document.at("channels").as_array().at(4).as_object();
    CHECK(channel.at("from").as_object().at("process") == "pumps[4]");
    CHECK(channel.at("carrier").as_object().at("from").as_object().at("link") == 1);
    CHECK(channel.at("carrier").as_object().at("in_packets") == true);
}

TEST_CASE("the JSON document is UTF-8 for any bytes in the file") {
    auto text = [](const std::string& value) {
        auto result = read_netlist_text("T800 t; process (interface (char s[9])) p; use \"p.lku\" for p; place p on t;"
                                        "p (s = \"" +
                                            value + "\");",
                                        small_catalogue());
        auto document = boost::json::parse(print_json(result.network.value()));
        return std::string(document.at("processes").at(0).at("parameters").at("s").as_string());
    };
    CHECK(text("Stra\xc3\x9f"
               "e") == "Stra\xc3\x9f"
                       "e"); // UTF-8
    CHECK(text("Stra\xdf"
               "e") == "Stra\xc3\x9f"
                       "e");                                   // Latin-1
    CHECK(text("\xed\xa0\x80") == "\xc3\xad\xc2\xa0\xc2\x80"); // half of a surrogate pair, not a character
}

TEST_CASE("the drawing names nodes, processes and the links of each wire") {
    auto result = read_netlist(netlist_folder() + "/good/shared.cfs", small_catalogue());
    REQUIRE(result.network);
    auto dot = print_dot(*result.network);
    CHECK(dot.find("<b>a</b>") != std::string::npos);
    CHECK(dot.find("pumps[4]") != std::string::npos);
    CHECK(dot.find("n0 -- n1 [taillabel=\"1\", headlabel=\"0\"]") != std::string::npos);
    CHECK(dot.find("n0 -- n1 [taillabel=\"0\", headlabel=\"3\"]") != std::string::npos);
}

TEST_CASE("an interface is printed in its order, with its types and sizes") {
    auto result = read_netlist(netlist_folder() + "/good/tables.cfs", small_catalogue());
    REQUIRE(result.network);
    auto printed = print_cfs(*result.network);
    std::size_t at = printed.find("process (interface (");
    for (const char* entry :
         {"int first", "input in", "char name[5]", "char all[4][5]", "output out[2]", "unsigned mask",
          "short table[2][2]", "float gain", "double exact", "long large", "char initial", "char raw[3]"}) {
        CAPTURE(entry);
        at = printed.find(entry, at);
        REQUIRE(at != std::string::npos);
    }
    CHECK(printed.find("all = {\"north\", \"east\", \"south\", \"west\"},\n") != std::string::npos);
    CHECK(printed.find("p[1] (name = \"east\", first = 4, initial = 101);") != std::string::npos);
}

TEST_CASE("parameters are printed in the order of the netlist, which does not affect the hash") {
    auto text = [](const char* parameters) {
        return std::string("T800 t; process m; use \"ga.master\" for m; process s; use \"ga.slave\" for s; m (") +
               parameters + "); connect m.out to s.in; connect s.out to m.back; place m on t; place s on t;";
    };
    auto one = read_netlist_text(text("mutation = 0.5, population = 30, code = \"gray\""), small_catalogue());
    auto other = read_netlist_text(text("code = \"gray\", population = 30"), small_catalogue(), {{"mutation", "0.5"}});
    REQUIRE(one.network);
    REQUIRE(other.network);
    CHECK(print_cfs(*one.network).find("m (mutation = 0.5, population = 30, code = \"gray\");") != std::string::npos);
    CHECK(print_cfs(*other.network).find("m (code = \"gray\", population = 30, mutation = 0.5);") != std::string::npos);
    CHECK(one.network->hash == other.network->hash);
    check_round_trip(*one.network);
    auto stand_in =
        read_netlist_text("T800 t; process (interface (int zeta, int alpha[2], int mid = 3)) p; use \"p.lku\" "
                          "for p; p (zeta = 1, alpha = {4, 5}); place p on t;",
                          small_catalogue());
    REQUIRE(stand_in.network);
    CHECK(print_cfs(*stand_in.network).find("p (mid = 3, zeta = 1, alpha = {4, 5});") != std::string::npos);
    check_round_trip(*stand_in.network);
}

TEST_CASE("the toolset's include is printed before the first use of its declarations") {
    auto printed = [](const char* text) {
        auto result = read_netlist_text(text, small_catalogue());
        INFO(render(result.diagnostics));
        REQUIRE(result.network);
        check_round_trip(*result.network);
        return print_cfs(*result.network);
    };
    const std::string include = "#include \"setconf.inc\"\n\n/* hardware */\n";
    CHECK(printed("T800 t;").starts_with(include));
    CHECK(printed("#include \"boards.inc\"\nval n 3;").starts_with(include));
    CHECK(printed("val n 3;").starts_with("/* hardware */\n"));
    CHECK(printed("T800 t; connect t.link[0] to host;").starts_with(include + "T800 (memory = 4096) t;\nconnect "));
    CHECK(printed("edge host; T800 t; connect t.link[0] to host;")
              .starts_with(include + "edge host;\nT800 (memory = 4096) t;\n"));
    CHECK(printed("edge near; T800 t; connect t.link[0] to near;").starts_with(include + "edge near;\n"));
}

TEST_CASE("a process of a known kind keeps its interface") {
    auto result = read_netlist_text("T800 t; process (interface (input in, int cycles, output out)) s;"
                                    "use \"ga.slave\" for s; input i; output o; connect i to s.in; connect s.out to o;"
                                    "connect t.link[0] to host; place s on t;",
                                    small_catalogue());
    REQUIRE(result.network);
    CHECK(print_cfs(*result.network).find("process (interface (input in, int cycles, output out)) s;") !=
          std::string::npos);
    check_round_trip(*result.network);
}
