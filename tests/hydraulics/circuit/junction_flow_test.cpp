#include "hydraulics/circuit/flow_split.hpp"
#include "hydraulics/circuit/junction_flow.hpp"
#include "runtime/random.hpp"
#include "tests/hydraulics/circuit/link_sets.hpp"
#include "tests/hydraulics/circuit/rounded_flow.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using test::rounded_flow;

namespace {

constexpr double pump = 175;

Circuit bucket_then_boom() { return circuit_of(Configuration::a, {Link::bucket, Link::boom}); }

/// Returns the junction's pressure beyond the bypass.
double next_psi(const Circuit& circuit, std::size_t j, const std::vector<JunctionFlow>& flows) {
    return circuit[j].through == Through::junction ? flows[circuit[j].next].psi : rounded_flow.tank_psi;
}

double inflow(const Circuit& circuit, std::size_t j, const std::vector<JunctionFlow>& flows) {
    double sum = circuit[j].pumps * pump;
    for (std::size_t i = 0; i < j; ++i)
        if (circuit[i].through == Through::junction && circuit[i].next == j)
            sum += flows[i].bypass_in3_per_s;
    return sum;
}

/// Returns the orifice flow k a sqrt(drop), never backwards.
double law(double area_in2, double from_psi, double to_psi) {
    return 100 * area_in2 * std::sqrt(std::max(from_psi - to_psi, 0.0));
}

/// Checks every equation that a solution must satisfy.
void check_solution(const Circuit& circuit, const std::vector<JunctionOpening>& openings,
                    const std::vector<JunctionFlow>& flows) {
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        CAPTURE(j);
        const JunctionFlow& at = flows[j];
        double bypass_in2 = circuit[j].through == Through::nowhere ? 0 : openings[j].bypass_in2;
        double out = at.inlet_in3_per_s + at.bypass_in3_per_s + at.relief_in3_per_s;
        CHECK(std::abs(inflow(circuit, j, flows) - out) < 1e-9 * pump);
        CHECK(std::abs(at.inlet_in3_per_s - law(openings[j].inlet_in2, at.psi, openings[j].link_psi)) < 1e-6 * pump);
        CHECK(std::abs(at.bypass_in3_per_s - law(bypass_in2, at.psi, next_psi(circuit, j, flows))) < 1e-6 * pump);
        CHECK(at.inlet_in3_per_s >= 0);
        CHECK(at.bypass_in3_per_s >= 0);
        CHECK(at.relief_in3_per_s >= 0);
        CHECK(at.psi <= rounded_flow.relief_psi);
        if (at.relief_in3_per_s > 0) {
            CHECK(circuit[j].pumps > 0);
            CHECK(at.psi == rounded_flow.relief_psi);
        }
    }
}

double random_area(RandomStream& random) { return random.chance(0.15) ? 0 : 0.3 * random.uniform(); }

std::vector<JunctionOpening> random_openings(const Circuit& circuit, RandomStream& random) {
    std::vector<JunctionOpening> openings;
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        double link_psi = random.chance(0.05) ? 6000 * random.uniform() : 3000 * random.uniform() - 100;
        double inlet_in2 = random_area(random);
        openings.push_back({link_psi, inlet_in2, random_area(random)});
    }
    return openings;
}

/// Draws a solution, and computes openings with this solution. Each junction's inflow is split between inlet and
/// bypass; the pressure drops between junctions are random.
struct MadeUp {
    std::vector<JunctionOpening> openings;
    std::vector<JunctionFlow> flows;
};

MadeUp made_up(const Circuit& circuit, RandomStream& random) {
    MadeUp made{std::vector<JunctionOpening>(circuit.size()), std::vector<JunctionFlow>(circuit.size())};
    for (std::size_t j = circuit.size(); j-- > 0;)
        made.flows[j].psi = next_psi(circuit, j, made.flows) + 50 + 1000 * random.uniform();
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        JunctionFlow& at = made.flows[j];
        double in = inflow(circuit, j, made.flows);
        double share = circuit[j].through == Through::nowhere ? 1 : 0.05 + 0.9 * random.uniform();
        double link_psi = at.psi - 5 - 100 * random.uniform();
        at.inlet_in3_per_s = share * in;
        at.bypass_in3_per_s = in - at.inlet_in3_per_s;
        made.openings[j] = {link_psi, at.inlet_in3_per_s / (100 * std::sqrt(at.psi - link_psi)),
                            at.bypass_in3_per_s / (100 * std::sqrt(at.psi - next_psi(circuit, j, made.flows)))};
    }
    return made;
}

} // namespace

TEST_CASE("bucket and boom of configuration a satisfy B.3 and B.4 at given pressures") {
    auto flows = solve_junctions(bucket_then_boom(), {{{2000, 0.1, 0.068}, {1700, 0.096, 0.016}}}, rounded_flow);
    CHECK(std::abs(flows[0].psi - 2032.168) < 1e-3);
    CHECK(std::abs(flows[1].psi - 1729.594) < 1e-3);
    CHECK(std::abs(flows[0].inlet_in3_per_s - 56.7165) < 1e-3);
    CHECK(std::abs(flows[0].bypass_in3_per_s - 118.2835) < 1e-3);
    CHECK(std::abs(flows[1].inlet_in3_per_s - 52.2247) < 1e-3);
    CHECK(std::abs(flows[1].bypass_in3_per_s - 66.0588) < 1e-3);
}

TEST_CASE("the solution of one junction equals the flow split") {
    RandomStream random(5, "one junction");
    Circuit boom = circuit_of(Configuration::a, {Link::boom});
    for (int i = 0; i < 5000; ++i) {
        auto openings = random_openings(boom, random);
        FlowSplit split = split_flow(openings[0].inlet_in2, openings[0].bypass_in2, openings[0].link_psi, rounded_flow);
        auto flows = solve_junctions(boom, openings, rounded_flow);
        CHECK(flows[0].psi == split.pump_psi);
        CHECK(flows[0].inlet_in3_per_s == split.inlet_in3_per_s);
        CHECK(flows[0].bypass_in3_per_s == split.bypass_in3_per_s);
        CHECK(flows[0].relief_in3_per_s == split.relief_in3_per_s);
    }
}

TEST_CASE("flow is conserved and never backward, for any areas, pressures, configuration and links") {
    RandomStream random(7, "junction flow");
    int draws = 0, relieved = 0, shut = 0, unreached = 0;
    for (int round = 0; round < 200; ++round)
        for_each_circuit([&](Configuration configuration, LinkSet, const Circuit& circuit) {
            CAPTURE(std::string(1, name_of(configuration)));
            CAPTURE(circuit.size());
            auto openings = random_openings(circuit, random);
            auto flows = solve_junctions(circuit, openings, rounded_flow);
            check_solution(circuit, openings, flows);
            ++draws;
            for (std::size_t j = 0; j < circuit.size(); ++j) {
                relieved += flows[j].relief_in3_per_s > 0;
                shut += openings[j].inlet_in2 > 0 && flows[j].inlet_in3_per_s == 0;
                unreached += inflow(circuit, j, flows) == 0;
            }
        });
    CHECK(draws >= 10000);
    CHECK(relieved > 500); // each case must occur often
    CHECK(shut > 1000);
    CHECK(unreached > 500);
}

TEST_CASE("a constructed solution is found, in every configuration with every set of links") {
    RandomStream random(11, "made up");
    for (int round = 0; round < 30; ++round)
        for_each_circuit([&](Configuration configuration, LinkSet, const Circuit& circuit) {
            CAPTURE(std::string(1, name_of(configuration)));
            CAPTURE(circuit.size());
            MadeUp made = made_up(circuit, random);
            auto flows = solve_junctions(circuit, made.openings, rounded_flow);
            for (std::size_t j = 0; j < circuit.size(); ++j) {
                CHECK(flows[j].psi == doctest::Approx(made.flows[j].psi).epsilon(1e-9));
                CHECK(flows[j].inlet_in3_per_s == doctest::Approx(made.flows[j].inlet_in3_per_s).epsilon(1e-7));
                CHECK(std::abs(flows[j].bypass_in3_per_s - made.flows[j].bypass_in3_per_s) < 1e-6);
                CHECK(flows[j].relief_in3_per_s == 0);
            }
        });
}

TEST_CASE("a heavier load on any link lowers no junction's pressure and does not increase the link's flow") {
    RandomStream random(13, "heavier load");
    for (int round = 0; round < 50; ++round)
        for_each_circuit([&](Configuration, LinkSet, const Circuit& circuit) {
            auto openings = random_openings(circuit, random);
            auto before = solve_junctions(circuit, openings, rounded_flow);
            auto link = static_cast<std::size_t>(random.uniform() * static_cast<double>(circuit.size()));
            openings[link].link_psi += 300 * random.uniform();
            auto behind = solve_junctions(circuit, openings, rounded_flow);
            for (std::size_t j = 0; j < circuit.size(); ++j)
                CHECK(behind[j].psi >= before[j].psi - 1e-6);
            CHECK(behind[link].inlet_in3_per_s <= before[link].inlet_in3_per_s + 1e-4);
        });
}

TEST_CASE("the bucket alone in configuration b takes its pump's whole flow, up to the relief pressure") {
    Circuit bucket = circuit_of(Configuration::b, {Link::bucket});
    auto flows = solve_junctions(bucket, {{{1600, 0.1, 0.2}}}, rounded_flow); // the bypass has no effect
    CHECK(flows[0].inlet_in3_per_s == 175);
    CHECK(flows[0].psi == doctest::Approx(1600 + 17.5 * 17.5));
    flows = solve_junctions(bucket, {{{4400, 0.1, 0.2}}}, rounded_flow);
    CHECK(flows[0].psi == 4500);
    CHECK(flows[0].inlet_in3_per_s == doctest::Approx(100));
    CHECK(flows[0].relief_in3_per_s == doctest::Approx(75));
}

TEST_CASE("the boom alone in configuration d is fed by both pumps") {
    auto flows = solve_junctions(circuit_of(Configuration::d, {Link::boom}), {{{9000, 0.1, 0.07}}}, rounded_flow);
    CHECK(flows[0].bypass_in3_per_s == 350);
    CHECK(flows[0].psi == doctest::Approx(25 + 50 * 50));
}

TEST_CASE("a junction without flow has the pressure of the junction before it") {
    // The bucket takes the whole flow, so its pressure stays below the tank's.
    auto flows = solve_junctions(bucket_then_boom(), {{{-100, 2, 0.3}, {50, 0.1, 0.1}}}, rounded_flow);
    CHECK(flows[0].psi == doctest::Approx(-100 + 0.875 * 0.875));
    CHECK(flows[1].psi == flows[0].psi);
    CHECK(flows[1].inlet_in3_per_s == 0);
    CHECK(flows[1].bypass_in3_per_s == 0);
    // The boom is a dead end: both its orifices are shut.
    flows = solve_junctions(bucket_then_boom(), {{{1700, 0.1, 0.3}, {50, 0, 0}}}, rounded_flow);
    CHECK(flows[0].psi == doctest::Approx(1700 + 17.5 * 17.5));
    CHECK(flows[1].psi == flows[0].psi);
    // The boom is cut off from the pump; only its own orifices matter.
    flows = solve_junctions(bucket_then_boom(), {{{1700, 0.1, 0}, {50, 0.1, 0.1}}}, rounded_flow);
    CHECK(flows[1].psi == 25);
    flows = solve_junctions(bucket_then_boom(), {{{1700, 0.1, 0}, {50, 0.1, 0}}}, rounded_flow);
    CHECK(flows[1].psi == 50);
    flows = solve_junctions(bucket_then_boom(), {{{1700, 0.1, 0}, {50, 0, 0}}}, rounded_flow);
    CHECK(flows[1].psi == 25);
}

TEST_CASE("with all paths shut the pump's flow goes over its relief valve") {
    auto flows = solve_junctions(bucket_then_boom(), {{{5000, 0.1, 0.1}, {5000, 0.1, 0}}}, rounded_flow);
    CHECK(flows[0].psi == 4500);
    CHECK(flows[0].relief_in3_per_s == 175);
    CHECK(flows[1].psi == 4500);
}
