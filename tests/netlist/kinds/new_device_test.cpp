// Tests that a new device is declared, wired, checked and printed with nothing but its description.

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

DeviceKind repeater() {
    using namespace description;
    return {.name = "repeater",
            .noun = "a repeater",
            .about = "Refreshes the signal of a long wire.",
            .models = {{.name = "R2", .links = 2}, {.name = "R8", .links = 8, .attributes = {{"gain", 2.5}}}},
            .links = LinkRole::crosses,
            .attributes = {{.value = real("gain", {.unit = "V/V", .by_default = 1.0, .least = 0, .most = 10}, "of it"),
                            .json_name = "gain"},
                           {.value = text("label", {.by_default = ""}, "on its case"), .json_name = "label"}},
            .drawing = {.shape = Drawing::Shape::crossed_box}};
}

ReadResult read(const std::string& text) {
    Catalogue catalogue;
    catalogue.add_device(repeater());
    return read_netlist_text(text, catalogue);
}

std::string first_message(const std::string& text) { return read(text).diagnostics.at(0).message; }

} // namespace

TEST_CASE("a new device passes a wire through and is printed with its attributes") {
    ReadResult result = read("T800 a, b; R2 (label = \"cable 7\") r; R8 unused;\n"
                             "connect a.link[0] to r.link[0]; connect r.link[0] to r.link[1];\n"
                             "connect r.link[1] to b.link[3];");
    REQUIRE(result.network);
    REQUIRE(result.network->connections.size() == 1);
    CHECK(result.network->connections[0].crossings.size() == 1);
    CHECK(count_processors(*result.network) == 2); // a and b
    std::string printed = print_cfs(*result.network);
    CHECK(printed.find("R2 (label = \"cable 7\") r;\nR8 (gain = 2.5) unused;\n") != std::string::npos);
    CHECK(print_cfs(read(printed).network.value()) == printed);
    std::string json = print_json(*result.network);
    CHECK(json.find("\"type\":\"R8\",\"kind\":\"repeater\",\"gain\":2.5E0,\"label\":\"\"") != std::string::npos);
    CHECK(print_dot(*result.network).find("1 R2") != std::string::npos);
}

TEST_CASE("errors of a new device are reported") {
    CHECK(first_message("R2 (gain = 11) r;") == "illegal value of the attribute \"gain\": 11");
    CHECK(first_message("R2 (gain = \"high\") r;") == "wrong type for the attribute \"gain\": \"high\" is a string");
    CHECK(first_message("R2 (label = 3) r;") == "wrong type for the attribute \"label\": 3 is an integer");
    CHECK(first_message("R2 (clock = 3) r;") == "a node has no attribute \"clock\"");
    CHECK(first_message("R2 r; process p; place p on r;") == "\"r\" is a repeater: no process can be placed on it");
    CHECK(first_message("R2 r; T800 t; connect r.link[2] to t.link[0];") == "\"r\" has no link 2");
}
