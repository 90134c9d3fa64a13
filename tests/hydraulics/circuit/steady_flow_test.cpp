#include "hydraulics/circuit/flow_constants_fit.hpp"
#include "hydraulics/circuit/steady_flow.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

const FlowConstants rounded{100, 175, 25, 4500};

/// Returns the change of flow in percent of the flow at the tabulated spool.
double change_percent(const SteadyFlowPoint& point, double spool_error_in) {
    double right = steady_boom_flow(point.spool_in, point.inlet_psi, rounded).inlet_in3_per_s;
    double wrong = steady_boom_flow(point.spool_in + spool_error_in, point.inlet_psi, rounded).inlet_in3_per_s;
    return 100 * (wrong / right - 1);
}

const SteadyFlowPoint& entry(double flow, double psi) {
    return *std::ranges::find_if(
        table_2_6(), [&](const SteadyFlowPoint& p) { return p.inlet_in3_per_s == flow && p.inlet_psi == psi; });
}

} // namespace

TEST_CASE("Table 2.6: flow within 0.15 in^3/s at the tabulated spools, spool within 2e-4 in") {
    REQUIRE(table_2_6().size() == 9);
    for (const SteadyFlowPoint& point : table_2_6()) {
        CAPTURE(point.spool_in);
        double flow = steady_boom_flow(point.spool_in, point.inlet_psi, rounded).inlet_in3_per_s;
        CHECK(std::abs(flow - point.inlet_in3_per_s) < 0.15);
        double spool = boom_spool_for_flow(point.inlet_in3_per_s, point.inlet_psi, rounded);
        CHECK(std::abs(spool - point.spool_in) < 2e-4);
    }
}

TEST_CASE("the spool from a flow is the inverse of the flow from a spool") {
    for (double psi : {20.0, 500.0, 1630.0, 3000.0})
        for (double flow : {0.01, 1.0, 40.0, 120.0, 174.99}) {
            CAPTURE(psi);
            CAPTURE(flow);
            double spool = boom_spool_for_flow(flow, psi, rounded);
            CHECK(steady_boom_flow(spool, psi, rounded).inlet_in3_per_s == doctest::Approx(flow).epsilon(1e-9));
        }
    CHECK(boom_spool_for_flow(175, 1630, rounded) == doctest::Approx(0.376));
}

TEST_CASE("an impossible flow is refused") {
    CHECK_THROWS_AS(boom_spool_for_flow(0, 1630, rounded), std::domain_error);
    CHECK_THROWS_AS(boom_spool_for_flow(175.1, 1630, rounded), std::domain_error);
    CHECK_THROWS_AS(boom_spool_for_flow(50, 4500, rounded), std::domain_error); // the relief valve is open
    CHECK_THROWS_AS(boom_spool_for_flow(std::nan(""), 1630, rounded), std::domain_error);
}

TEST_CASE("as in the thesis, 0.02 in of spool change the flow by up to 50 %, 0.01 in by about 20 %") {
    CHECK(std::abs(change_percent(entry(40, 1630), 0.02) - 50) < 2);
    CHECK(std::abs(change_percent(entry(50, 1630), 0.01) - 20) < 1.5);
    for (const SteadyFlowPoint& point : table_2_6()) {
        CAPTURE(point.spool_in);
        CHECK(change_percent(point, 0.02) > 33);
        CHECK(change_percent(point, 0.02) < 56);
        CHECK(change_percent(point, 0.01) > 16);
        CHECK(change_percent(point, 0.01) < 28);
        CHECK(0.02 / point.spool_in < 0.083); // the thesis's "8 %"
    }
}

TEST_CASE("the sensitivity of the flow is the implicit derivative of Q_i + k a_e sqrt(P - P_e) = Q") {
    for (const SteadyFlowPoint& point : table_2_6()) {
        CAPTURE(point.spool_in);
        FlowSensitivity sensitivity = boom_flow_sensitivity(point.spool_in, point.inlet_psi, rounded);
        FlowSplit split = steady_boom_flow(point.spool_in, point.inlet_psi, rounded);
        double inlet = 100 * 1.247 * (point.spool_in - 0.188), bypass = 100 * 0.25 * (0.376 - point.spool_in);
        double root = std::sqrt(split.pump_psi - 25), flow = split.inlet_in3_per_s;
        double to_flow = 1 + bypass * flow / (root * inlet * inlet);
        double to_psi = bypass / (2 * root);
        double to_spool = -25 * root - bypass / root * flow * flow / std::pow(inlet, 3) * 124.7;
        CHECK(sensitivity.to_pressure_in3_per_s_psi == test::nearly(-to_psi / to_flow, 1e-6));
        CHECK(sensitivity.to_spool_in3_per_s_in == test::nearly(-to_spool / to_flow, 1e-6));
        CHECK(sensitivity.to_spool_in3_per_s_in > 990);
        CHECK(sensitivity.to_spool_in3_per_s_in < 1120);
        CHECK(sensitivity.to_pressure_in3_per_s_psi < -0.027);
        CHECK(sensitivity.to_pressure_in3_per_s_psi > -0.039);
    }
}
