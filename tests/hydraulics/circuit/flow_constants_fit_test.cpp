#include "hydraulics/circuit/flow_constants_fit.hpp"
#include "hydraulics/circuit/steady_flow.hpp"
#include "tests/hydraulics/circuit/rounded_flow.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using test::rounded_flow;

namespace {

// The model minus the table, in 1e-4 in, computed independently, to the digits given.
constexpr double fitted_residuals[] = {-0.61, -0.22, -0.29, 0.65, 1.38, 0.07, -0.47, -0.50, -0.12};
constexpr double rounded_residuals[] = {-0.39, -0.24, -0.62, 0.82, 1.29, -0.37, -0.35, -0.66, -0.65};

} // namespace

TEST_CASE("the rounded constants have the printed values") {
    const FlowConstants& rounded = rounded_flow_constants();
    CHECK(rounded.orifice_in3_per_s_in2_sqrt_psi == rounded_flow.orifice_in3_per_s_in2_sqrt_psi);
    CHECK(rounded.pump_in3_per_s == rounded_flow.pump_in3_per_s);
    CHECK(rounded.tank_psi == rounded_flow.tank_psi);
    CHECK(rounded.relief_psi == rounded_flow.relief_psi);
}

TEST_CASE("both sets of constants have the known residuals for Table 2.6") {
    auto fitted = spool_residuals_in(table_2_6(), fitted_flow_constants());
    auto round = spool_residuals_in(table_2_6(), rounded_flow_constants());
    for (std::size_t i = 0; i < 9; ++i) {
        CHECK(std::abs(fitted[i] * 1e4 - fitted_residuals[i]) < 0.0051);
        CHECK(std::abs(round[i] * 1e4 - rounded_residuals[i]) < 0.0051);
    }
}

TEST_CASE("the fit to Table 2.6 gives the same constants and residuals from any start") {
    for (const FlowConstants& start :
         {rounded_flow, FlowConstants{90, 160, 100, 4500}, FlowConstants{110, 190, 0, 4500}}) {
        FlowConstantsFit fit = fit_flow_constants(table_2_6(), start);
        CHECK(std::abs(fit.constants.orifice_in3_per_s_in2_sqrt_psi - 99.83) < 0.02);
        CHECK(std::abs(fit.constants.pump_in3_per_s - 175.08) < 0.02);
        CHECK(std::abs(fit.constants.tank_psi - 16.2) < 0.5);
        CHECK(fit.constants.relief_psi == start.relief_psi);
        CHECK(std::abs(fit.rms_in - 0.61e-4) < 0.01e-4);
        for (std::size_t i = 0; i < 9; ++i)
            CHECK(std::abs(fit.residuals_in[i] - fitted_residuals[i] * 1e-4) < 0.02e-4);
        CHECK(std::abs(fit.deviation.orifice_in3_per_s_in2_sqrt_psi - 0.4) < 0.1);
        CHECK(std::abs(fit.deviation.pump_in3_per_s - 0.4) < 0.1);
        CHECK(std::abs(fit.deviation.tank_psi - 9) < 3);
    }
}

TEST_CASE("without its worst entry, Table 2.6 is fitted to within its rounding") {
    std::vector<SteadyFlowPoint> table(table_2_6().begin(), table_2_6().end());
    table.erase(table.begin() + 4);
    FlowConstantsFit fit = fit_flow_constants(table, rounded_flow);
    CHECK(std::abs(fit.constants.orifice_in3_per_s_in2_sqrt_psi - 99.86) < 0.02);
    CHECK(std::abs(fit.constants.pump_in3_per_s - 175.06) < 0.02);
    CHECK(std::abs(fit.rms_in - 0.38e-4) < 0.01e-4);
}

TEST_CASE("a fit recovers the constants of a computed table") {
    std::vector<SteadyFlowPoint> table;
    for (double psi : {600.0, 1500.0, 2500.0})
        for (double rate : {20.0, 60.0, 120.0})
            table.push_back({rate, psi, boom_spool_for_flow(rate, psi, {93, 150, 60, 4500})});
    FlowConstantsFit fit = fit_flow_constants(table, rounded_flow);
    CHECK(fit.constants.orifice_in3_per_s_in2_sqrt_psi == doctest::Approx(93).epsilon(1e-6));
    CHECK(fit.constants.pump_in3_per_s == doctest::Approx(150).epsilon(1e-6));
    CHECK(fit.constants.tank_psi == doctest::Approx(60).epsilon(1e-5));
    CHECK(fit.rms_in < 1e-8);
    table.resize(3);
    CHECK_THROWS_AS(fit_flow_constants(table, rounded_flow), std::invalid_argument);
}
