#include "hydraulics/circuit/circuit.hpp"
#include "tests/hydraulics/circuit/link_sets.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

std::string text_of(LinkSet links) {
    std::string text;
    for (Link link : all_links)
        if (links.contains(link))
            text += fmt::format("{}{}", text.empty() ? "" : ",", symbol_of(link));
    return "{" + text + "}";
}

std::string groups_of(Configuration configuration) {
    std::string text;
    for (LinkSet group : coupled_groups(configuration))
        text += (text.empty() ? "" : "|") + text_of(group);
    return text;
}

/// Returns one word for each junction: a plus for each of its pumps, its link, and where the bypass leads.
std::string text_of(const Circuit& circuit) {
    std::string text;
    for (const Junction& junction : circuit) {
        std::string to = junction.through == Through::tank      ? "tank"
                         : junction.through == Through::nowhere ? "nowhere"
                                                                : std::string(symbol_of(circuit[junction.next].link));
        text += fmt::format("{}{}{}>{}", text.empty() ? "" : " ",
                            std::string(static_cast<std::size_t>(junction.pumps), '+'), symbol_of(junction.link), to);
    }
    return text;
}

constexpr Link BU = Link::bucket, BO = Link::boom, ST = Link::stick, SW = Link::swing;

void check_circuit(char configuration, LinkSet active, const std::string& expected) {
    CAPTURE(configuration);
    CHECK(text_of(circuit_of(*configuration_named(std::string(1, configuration)), active)) == expected);
}

} // namespace

TEST_CASE("each configuration has its groups of coupled links") {
    CHECK(groups_of(Configuration::a) == "{BU,BO}|{ST,SW}");
    CHECK(groups_of(Configuration::b) == "{BU}|{BO,ST,SW}");
    CHECK(groups_of(Configuration::c) == "{BU,BO,ST}|{SW}");
    CHECK(groups_of(Configuration::d) == "{BU,BO,ST,SW}");
    CHECK(groups_of(Configuration::e) == "{BU,BO,ST,SW}");
}

TEST_CASE("configuration a has two branches with a pump each") {
    check_circuit('a', {BU, BO}, "+BU>BO BO>tank"); // Figure B.1
    check_circuit('a', {ST, SW}, "+SW>ST ST>tank");
    check_circuit('a', {BU}, "+BU>tank");
    check_circuit('a', {BO}, "+BO>tank");
    check_circuit('a', {ST}, "+ST>tank");
    check_circuit('a', {SW}, "+SW>tank");
}

TEST_CASE("in configuration b the bucket has pump 1 alone, and branch 2 feeds the boom") {
    check_circuit('b', {BU}, "+BU>nowhere");
    check_circuit('b', {BO, ST, SW}, "+SW>ST ST>BO BO>tank");
    check_circuit('b', {BO, ST}, "+ST>BO BO>tank");
    check_circuit('b', {BO, SW}, "+SW>BO BO>tank"); // the stick is at rest, so the flow passes it
    check_circuit('b', {ST, SW}, "+SW>ST ST>tank"); // the boom is at rest, so the flow passes it
    check_circuit('b', {BO}, "+BO>tank");
    check_circuit('b', {ST}, "+ST>tank");
    check_circuit('b', {SW}, "+SW>tank");
}

TEST_CASE("in configuration c the swing has pump 2 alone, and branch 1 feeds the stick") {
    check_circuit('c', {SW}, "+SW>nowhere");
    check_circuit('c', {BU, BO, ST}, "+BU>BO BO>ST ST>tank");
    check_circuit('c', {BU, ST}, "+BU>ST ST>tank");
    check_circuit('c', {BO, ST}, "+BO>ST ST>tank");
    check_circuit('c', {BU, BO}, "+BU>BO BO>tank");
    check_circuit('c', {ST}, "+ST>tank");
}

TEST_CASE("in configuration d both branches feed the boom") {
    check_circuit('d', LinkSet::all(), "+BU>BO +SW>ST ST>BO BO>tank");
    check_circuit('d', {BU, SW, BO}, "+BU>BO +SW>BO BO>tank");
    check_circuit('d', {BO, ST, SW}, "+SW>ST ST>BO +BO>tank"); // pump 1 passes the bucket, which is at rest
    check_circuit('d', {BO}, "++BO>tank");
    check_circuit('d', {BU, ST}, "+BU>tank +ST>tank"); // they meet at the boom, which is at rest
}

TEST_CASE("in configuration e both branches feed the stick") {
    check_circuit('e', LinkSet::all(), "+SW>ST +BU>BO BO>ST ST>tank");
    check_circuit('e', {BU, BO, ST}, "+BU>BO BO>ST +ST>tank");
    check_circuit('e', {BU, SW, ST}, "+SW>ST +BU>ST ST>tank");
    check_circuit('e', {ST}, "++ST>tank");
    check_circuit('e', {BO, SW}, "+SW>tank +BO>tank");
}

TEST_CASE("in every circuit each usable pump feeds one junction, and bypasses lead to the next") {
    int circuits = 0;
    for_each_circuit([&](Configuration configuration, LinkSet active, const Circuit& circuit) {
        CAPTURE(name_of(configuration));
        CAPTURE(text_of(active));
        ++circuits;
        LinkSet found;
        int pumps = 0;
        for (std::size_t j = 0; j < circuit.size(); ++j) {
            found.insert(circuit[j].link);
            pumps += circuit[j].pumps;
            if (circuit[j].through == Through::junction) {
                CHECK(circuit[j].next > j);
                CHECK(circuit[j].next < circuit.size());
            }
        }
        CHECK(found == active);
        CHECK(circuit.size() == active.size());
        CHECK(pumps >= 1);
        CHECK(pumps <= 2);
    });
    CHECK(circuits == 52); // configurations a to e have 3+3, 1+7, 7+1, 15 and 15
}
