// Tests which differences between two networks are found, and how their elements are grouped.

#include "explore/compare/differences.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using Section = StructureDifference::Section;

namespace {

Network csp_network(const std::string& text) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    ReadResult read = read_netlist_text(text, catalogue);
    INFO(render(read));
    REQUIRE(read.network);
    return std::move(*read.network);
}

std::vector<SettingDifference> differing_settings(const std::string& a, const std::string& b) {
    return setting_differences(csp_network(a), csp_network(b));
}

std::vector<StructureDifference> differing_structure(const std::string& a, const std::string& b) {
    return structure_differences(csp_network(a), csp_network(b));
}

/// Checks that exactly one section differs, and in what.
void check_section(const std::string& a, const std::string& b, Section section, const std::vector<std::string>& only_a,
                   const std::vector<std::string>& only_b) {
    const auto found = differing_structure(a, b);
    REQUIRE(found.size() == 1);
    CHECK(found[0].section == section);
    CHECK(found[0].only_a == only_a);
    CHECK(found[0].only_b == only_b);
}

using Names = std::vector<std::string>;
constexpr const char* pair_of_nodes = "T800 a, b; connect a.link[0] to b.link[0];";
const std::string stream =
    "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c; connect p.out to c.in;";

} // namespace

TEST_CASE("elements share a difference only if both their values are equal") {
    const std::string wires = "connect a.link[0] to b.link[0]; connect b.link[1] to c.link[0]; "
                              "connect c.link[1] to d.link[0];";
    const auto found =
        differing_settings("T800 (clock = 20M) a, b; T800 (clock = 25M) c; T800 (clock = 30M) d;" + wires,
                           "T800 (clock = 30M) a, b; T800 (clock = 30M) c; T800 (clock = 30M) d;" + wires);
    REQUIRE(found.size() == 2);
    CHECK(found[0].elements == Names{"a", "b"});
    CHECK(found[0].a == "20000000");
    CHECK(found[1].elements == Names{"c"});
    CHECK(found[1].a == "25000000");
    CHECK(found[1].set == Overrides{{"c.clock", "30000000"}});
}

TEST_CASE("elements that only one network has, or of another type, have no setting in common") {
    CHECK(differing_settings("T800 (clock = 20M) a;", "T800 (clock = 10M) b;").empty());
    CHECK(differing_settings("T800 (clock = 20M) a;", "T414 (clock = 10M) a;").empty());
    CHECK(differing_settings("T800 a;", "T800 a;").empty());
    CHECK(differing_settings("", "").empty());
}

TEST_CASE(
    "parameters of processes are compared by the process's name; a default that one netlist states does not count") {
    const auto found = differing_settings("T800 t; " + stream + "place p on t; place c on t; p (count = 5);",
                                          "T800 t; " + stream + "place p on t; place c on t; p (count = 7);");
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "count");
    CHECK(found[0].a == "5");
    CHECK(found[0].b == "7");
    CHECK(found[0].set == Overrides{{"p.count", "7"}});
    CHECK(differing_settings("T800 (clock = 20M) a;", "T800 a;").empty());
}

TEST_CASE("a named wire's length and own speed are its settings") {
    const std::string wire = "T800 a, b; connection w; connect a.link[0] to b.link[0] by w;";
    const auto found = differing_settings(wire + " w (length = 1);", wire + " w (length = 3);");
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "length");
    CHECK(found[0].elements == Names{"w"});
}

TEST_CASE("nodes and wires are the hardware; the direction in which a wire is written has no meaning") {
    check_section("T800 a;", "T414 a;", Section::hardware, {"T800 a"}, {"T414 a"});
    check_section(pair_of_nodes, "T800 a, b; connect a.link[0] to b.link[3];", Section::hardware,
                  {"a.link[0] to b.link[0]"}, {"a.link[0] to b.link[3]"});
    CHECK(differing_structure(pair_of_nodes, "T800 b, a; connect b.link[0] to a.link[0];").empty());
}

TEST_CASE("processes and channels are the software") {
    const std::string placed = "T800 t; " + stream + "place p on t; place c on t;";
    const auto found = differing_structure("T800 t;", placed);
    REQUIRE(found.size() == 2);
    CHECK(found[0].section == Section::software);
    CHECK(found[0].only_a.empty());
    CHECK(found[0].only_b == Names{"csp.consumer c", "csp.producer p", "p.out to c.in"});
    CHECK(found[1].only_b == Names{"c on t", "p on t"});
}

TEST_CASE("placements and routes are the mapping") {
    const auto found = differing_structure(pair_of_nodes + stream + "place p on a; place c on b;",
                                           pair_of_nodes + stream + "place p on a; place c on a;");
    REQUIRE(found.size() == 1);
    CHECK(found[0].section == Section::mapping);
    CHECK(found[0].only_a == Names{"c on b", "p.out to c.in over a.link[0]"});
    CHECK(found[0].only_b == Names{"c on a"});
}

TEST_CASE("faults are a section of their own") {
    const auto found =
        differing_structure(pair_of_nodes, std::string(pair_of_nodes) + " fault a.link[0] silent (from = 20ms);");
    REQUIRE(found.size() == 1);
    CHECK(found[0].section == Section::faults);
    REQUIRE(found[0].only_b.size() == 1);
    CHECK(found[0].only_b[0].find("silent") != std::string::npos);
}

TEST_CASE("sections have the names that a printed netlist uses") {
    CHECK(std::string(name_of(Section::hardware)) == "hardware");
    CHECK(std::string(name_of(Section::faults)) == "faults");
}
