// Tests that a network that loaded once loads again when printed, however large it is.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/good_networks.hpp"
#include "tests/netlist/small_catalogue.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

void check_loads_again(const std::string& text) {
    Network network = good_text(text);
    std::string printed = print_cfs(network);
    auto again = read_netlist_text(printed, small_catalogue());
    INFO(render(again.diagnostics));
    REQUIRE(again.network);
    CHECK(print_cfs(*again.network) == printed);
}

std::string message_for(const std::string& text) {
    auto result = read_netlist_text(text, small_catalogue());
    CHECK_FALSE(result.network);
    return result.diagnostics.empty() ? "" : result.diagnostics[0].message;
}

} // namespace

// In these two networks, edges bring the size to the limit.

TEST_CASE("a network of processes with every parameter of their kind loads again" * doctest::skip(test::sanitized)) {
    check_loads_again("val n 5000; T800 t; edge e[214000]; process m[n], s[n];\n"
                      "use \"ga.master\" for m; use \"ga.slave\" for s; m (population = 30);\n"
                      "rep i = 0 for n { connect m[i].out to s[i].in; connect s[i].out to m[i].back;\n"
                      "place m[i] on t; place s[i] on t; }");
}

TEST_CASE("a network with many placed channels on one link loads again" * doctest::skip(test::sanitized)) {
    check_loads_again("val n 5000; T800 a, b; connect a.link[0] to b.link[0]; edge e[229000]; process p[n], s[n];\n"
                      "use \"pump\" for p; use \"sink\" for s;\n"
                      "rep i = 0 for n { connect p[i].out to s[i].in; place p[i] on a; place s[i] on b; }");
}

TEST_CASE("a network of the largest size loads again" * doctest::skip(test::sanitized)) {
    check_loads_again("T800 t; process p[249997]; rep i = 0 for 249997 place p[i] on t; connect t.link[0] to host;");
}

TEST_CASE("a network with arrays of long strings and of many numbers loads again" * doctest::skip(test::sanitized)) {
    std::string row(1900, 'x'), escaped;
    for (int i = 0; i < 1900; ++i)
        escaped += "\\1";
    std::string text = "T800 t; process (interface (char rows[24][2000], int numbers[100][1000])) p; place p on t;\n"
                       "use \"p.lku\" for p; val zeros {0";
    for (int i = 1; i < 1000; ++i)
        text += i % 50 == 0 ? ",\n0" : ", 0";
    text += "};\np (rows = {\"" + row;
    for (int i = 1; i < 24; ++i)
        text += "\",\n\"" + escaped;
    text += "\"}, numbers = {zeros";
    for (int i = 1; i < 100; ++i)
        text += i % 50 == 0 ? ",\nzeros" : ", zeros";
    check_loads_again(text + "});");
}

TEST_CASE("a network with repeated declarations of the longest names loads again") {
    std::string name(255, 'n');
    check_loads_again("T800 t; rep i = 0 for 12 { process (interface (output out[1][1][1])) " + name +
                      "; process (interface (input in)) " + name.substr(1) + "; connection c" + name.substr(2) +
                      "; connect " + name + ".out[0][0][0] to " + name.substr(1) + ".in by c" + name.substr(2) +
                      "; place " + name + " on t; place " + name.substr(1) + " on t; }");
    CHECK(message_for("T800 " + name + "n;") == "the name is too long: at most 255 characters are allowed");
}

TEST_CASE("a network whose routes are too long is refused with its size before its text is made") {
    const std::string pipeline = "T800 t[n]; process p[n - 1], s[n - 1]; use \"pump\" for p; use \"sink\" for s;\n"
                                 "rep i = 0 for n - 1 { connect t[i].link[2] to t[i + 1].link[1];\n"
                                 "connect p[i].out to s[i].in; place p[i] on t[0]; place s[i] on t[i + 1]; }";
    const Network small = good_text("val n 100;" + pipeline);
    CHECK(write_out(small, 10).bytes == print_cfs(small).size());
    CHECK(write_out(small, 10).text.empty());
    CHECK(message_for("val n 1200;" + pipeline).starts_with("the network is too large: written out it would have"));
}

TEST_CASE("a netlist whose printed form would be too large is refused" * doctest::skip(test::sanitized)) {
    std::string program(1900, 'x');
    CHECK(message_for("T800 t; rep i = 0 for 10000 { process p; use \"" + program + ".lku\" for p; place p on t; }")
              .starts_with("the network is too large: written out it would have"));
}
