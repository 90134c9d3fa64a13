#include "hydraulics/plant/feedforward.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "tests/hydraulics/circuit/link_sets.hpp"
#include "tests/hydraulics/circuit/rounded_flow.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using test::rounded_flow;

TEST_CASE("the areas of the feedforward give each link its flow, in every configuration") {
    for_each_circuit([](Configuration configuration, LinkSet, const Circuit& circuit) {
        CAPTURE(std::string(1, name_of(configuration)));
        CAPTURE(circuit.size());
        std::vector<FlowTarget> targets;
        for (std::size_t j = 0; j < circuit.size(); ++j)
            targets.push_back({1500 + 170.0 * static_cast<double>(index_of(circuit[j].link)), 40});
        auto flows = solve_junctions(circuit, openings_for(circuit, targets, rounded_flow, 30, 150), rounded_flow);
        for (std::size_t j = 0; j < circuit.size(); ++j) {
            bool alone = circuit[j].through == Through::nowhere;
            CHECK(flows[j].inlet_in3_per_s == doctest::Approx(alone ? 175 : 40).epsilon(1e-9));
            CHECK(flows[j].relief_in3_per_s == 0);
            CHECK(flows[j].psi >= targets[j].link_psi + 30 - 1e-6);
        }
    });
}

TEST_CASE("the feedforward of bucket and boom agrees with a hand computation") {
    Circuit circuit = circuit_of(Configuration::a, {Link::bucket, Link::boom});
    auto openings = openings_for(circuit, {{{1900, 50}, {1700, 55}}}, rounded_flow, 25, 175);
    CHECK(openings[1].inlet_in2 == doctest::Approx(55 / 500.0)); // P12 is 1725 psi: 25 psi over the boom's inlet
    CHECK(openings[1].bypass_in2 == doctest::Approx(70 / 4123.1056256));  // sqrt(1700 psi) to the tank
    CHECK(openings[0].inlet_in2 == doctest::Approx(50 / 500.0));          // P11 is 1925 psi > 1725 + 175
    CHECK(openings[0].bypass_in2 == doctest::Approx(125 / 1414.2135624)); // sqrt(200 psi) to junction 2
}

TEST_CASE("flows that no areas can give are refused") {
    Circuit circuit = circuit_of(Configuration::a, {Link::bucket, Link::boom});
    CHECK_THROWS_WITH_AS(openings_for(circuit, {{{1900, 100}, {1700, 100}}}, rounded_flow, 25, 175),
                         "the boom needs 100 in^3/s, but only 75.0 in^3/s reach its junction", UnfitScenario);
    CHECK_THROWS_WITH_AS(openings_for(circuit, {{{4490, 50}, {1700, 50}}}, rounded_flow, 25, 175),
                         "the bucket needs 4515 psi at its junction, but the relief valve opens at 4500 psi",
                         UnfitScenario);
}
