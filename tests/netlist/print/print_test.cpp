// A printed network loads again to the same network.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <filesystem>

using namespace placedpar;

namespace {

/// Everything but the places and the source: by way of JSON, which names every field of the structures.
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

TEST_CASE("what is printed loads again to the same network") {
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

TEST_CASE("and so it does for every number of slaves") {
    for (int slaves = 0; slaves < 12; ++slaves) {
        auto result = read_netlist(netlist_folder() + "/good/cluster_of_n.cfs", small_catalogue(),
                                   {{"slaves", std::to_string(slaves)}});
        REQUIRE(result.network);
        check_round_trip(*result.network);
    }
}

TEST_CASE("the hash is that of the network, not of the file") {
    auto hash = [](const std::string& text) { return read_netlist_text(text, small_catalogue()).network.value().hash; };
    CHECK(hash("T800 a, b; connect a.link[0] to b.link[0];") ==
          hash("val n 0; /* the same */ T800 (memory = 4k) a, b;\nconnect a.link[n], b.link[n];"));
    CHECK(hash("T800 a, b; connect a.link[0] to b.link[0];") != hash("T800 a, b; connect a.link[0] to b.link[1];"));
}

TEST_CASE("the JSON document") {
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
    CHECK(channel.at("carrier").as_object().at("shared") == true);
}

TEST_CASE("the JSON document is UTF-8 whatever the file is") {
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
    CHECK(text("\xed\xa0\x80") == "\xc3\xad\xc2\xa0\xc2\x80"); // half of a surrogate pair is no character
}

TEST_CASE("the drawing names what there is and the links of each wire") {
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
    CHECK(printed.find("p (all = {\"north\", \"east\", \"south\", \"west\"},\n") != std::string::npos);
    CHECK(printed.find("p[1] (first = 4, initial = 101, name = \"east\");") != std::string::npos);
}

TEST_CASE("an interface is kept for a process whose kind is known") {
    auto result = read_netlist_text("T800 t; process (interface (input in, int cycles, output out)) s;"
                                    "use \"ga.slave\" for s; input i; output o; connect i to s.in; connect s.out to o;"
                                    "connect t.link[0] to host; place s on t;",
                                    small_catalogue());
    REQUIRE(result.network);
    CHECK(print_cfs(*result.network).find("process (interface (input in, int cycles, output out)) s;") !=
          std::string::npos);
    check_round_trip(*result.network);
}
