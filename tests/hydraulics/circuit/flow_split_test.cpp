#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/flow_constants_fit.hpp"
#include "hydraulics/circuit/flow_split.hpp"
#include "runtime/random.hpp"
#include "tests/hydraulics/circuit/rounded_flow.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;
using test::rounded_flow;

namespace {

FlowSplit boom_split(double spool_in, double inlet_psi) {
    OrificeAreas areas = boom_orifices(spool_in);
    return split_flow(areas.inlet_in2, areas.bypass_in2, inlet_psi, rounded_flow);
}

/// Returns the spool position that gives this flow, by bisection, since the flow grows with the spool.
double spool_for(double inlet_in3_per_s, double inlet_psi) {
    double low = boom_dead_band_in, high = boom_bypass_shut_in;
    for (int i = 0; i < 60; ++i) {
        double middle = (low + high) / 2;
        (boom_split(middle, inlet_psi).inlet_in3_per_s < inlet_in3_per_s ? low : high) = middle;
    }
    return low;
}

} // namespace

TEST_CASE("Table 2.6 of the thesis: flow within 0.15 in^3/s, spool within 2e-4 in") {
    for (const SteadyFlowPoint& entry : table_2_6()) {
        CAPTURE(entry.spool_in);
        double inlet = boom_split(entry.spool_in, entry.inlet_psi).inlet_in3_per_s;
        CHECK(std::abs(inlet - entry.inlet_in3_per_s) < 0.15);
        CHECK(std::abs(spool_for(entry.inlet_in3_per_s, entry.inlet_psi) - entry.spool_in) < 2e-4);
    }
}

TEST_CASE("the flow split at spool .2650 in and 2030 psi agrees with the thesis") {
    FlowSplit split = boom_split(0.2650, 2030);
    CHECK(std::abs(split.pump_psi - 2057.017) < 1e-3);
    CHECK(std::abs(split.inlet_in3_per_s - 49.909) < 1e-3);
    CHECK(std::abs(split.bypass_in3_per_s - 125.091) < 1e-3);
    CHECK(split.relief_in3_per_s == 0);
}

TEST_CASE("the load check is shut if the pump cannot reach the cylinder's pressure") {
    FlowSplit split = boom_split(0.2, 1630);
    CHECK(split.inlet_in3_per_s == 0);
    CHECK(split.bypass_in3_per_s == 175);
    CHECK(split.pump_psi < 1630);
}

TEST_CASE("the relief valve opens at 4500 psi") {
    FlowSplit both_shut = split_flow(0, 0, 1500, rounded_flow);
    CHECK(both_shut.pump_psi == 4500);
    CHECK(both_shut.relief_in3_per_s == 175);

    FlowSplit small_inlet = split_flow(0.01, 0, 2900, rounded_flow); // .01 * 100 * sqrt(1600) = 40
    CHECK(small_inlet.inlet_in3_per_s == doctest::Approx(40));
    CHECK(small_inlet.relief_in3_per_s == doctest::Approx(135));

    FlowSplit overloaded = split_flow(0.2, 0, 5000, rounded_flow);
    CHECK(overloaded.inlet_in3_per_s == 0);
    CHECK(overloaded.relief_in3_per_s == 175);
}

TEST_CASE("any split satisfies the orifice equations and conserves the pump's flow") {
    RandomStream random(11, "flow split");
    int shut = 0, relieved = 0, reversed = 0;
    for (int i = 0; i < 20000; ++i) {
        double inlet_in2 = random.chance(0.1) ? 0 : 0.3 * random.uniform();
        double bypass_in2 = random.chance(0.1) ? 0 : 0.3 * random.uniform();
        double inlet_psi = -10 + 4000 * random.uniform() * random.uniform();
        FlowSplit split = split_flow(inlet_in2, bypass_in2, inlet_psi, rounded_flow);
        CAPTURE(inlet_in2);
        CAPTURE(bypass_in2);
        CAPTURE(inlet_psi);
        double drop_in = std::max(split.pump_psi - inlet_psi, 0.0);
        double drop_by = std::max(split.pump_psi - rounded_flow.tank_psi, 0.0);
        CHECK(std::abs(split.inlet_in3_per_s - 100 * inlet_in2 * std::sqrt(drop_in)) < 1e-6 * 175);
        CHECK(std::abs(split.bypass_in3_per_s - 100 * bypass_in2 * std::sqrt(drop_by)) < 1e-6 * 175);
        double total = split.inlet_in3_per_s + split.bypass_in3_per_s + split.relief_in3_per_s;
        CHECK(std::abs(total - 175) < 1e-9);
        CHECK(split.relief_in3_per_s >= 0);
        CHECK(split.pump_psi <= 4500);
        shut += split.inlet_in3_per_s == 0;
        relieved += split.relief_in3_per_s > 0;
        reversed += inlet_psi < rounded_flow.tank_psi;
    }
    CHECK(shut > 100); // each case must occur often
    CHECK(relieved > 100);
    CHECK(reversed > 100);
}

TEST_CASE("the prediction whether the path to the cylinder is open agrees with the flow split") {
    for (double spool_in = 0.189; spool_in < 0.25; spool_in += 0.0007) {
        CAPTURE(spool_in);
        bool predicted = bypass_only_psi(boom_orifices(spool_in).bypass_in2, rounded_flow) > 1600;
        CHECK((boom_split(spool_in, 1600).inlet_in3_per_s > 0) == predicted);
    }
}
