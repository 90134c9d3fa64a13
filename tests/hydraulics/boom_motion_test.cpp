#include "hydraulics/boom_motion.hpp"
#include "hydraulics/line_fit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace placedpar;

namespace {

BoomScenario long_scenario() {
    BoomScenario scenario;
    scenario.duration_s = 4;
    return scenario;
}

double greatest_slope_psi_per_s(const std::vector<BoomState>& motion) {
    double greatest = 0;
    for (std::size_t i = 1; i < motion.size(); ++i)
        greatest = std::max(greatest, (motion[i].inlet_psi - motion[i - 1].inlet_psi) /
                                          (motion[i].time_s - motion[i - 1].time_s));
    return greatest;
}

} // namespace

TEST_CASE("scenario A: the load is held until the spool moves") {
    std::vector<BoomState> motion = simulate_boom(BoomScenario());
    CHECK(motion.front().inlet_psi == doctest::Approx(1555).epsilon(1e-3));
    const BoomState& before = motion[200];
    CHECK(before.time_s == doctest::Approx(0.1));
    CHECK(std::abs(before.piston_in) < 1e-6);
    CHECK(before.inlet_psi == doctest::Approx(motion.front().inlet_psi).epsilon(1e-9));
}

TEST_CASE("scenario A: peak, steady state and steepest rise") {
    std::vector<BoomState> motion = simulate_boom(long_scenario());
    auto peak = std::max_element(motion.begin(), motion.end(),
                                 [](const BoomState& a, const BoomState& b) { return a.inlet_psi < b.inlet_psi; });
    CHECK(std::abs(peak->inlet_psi - 2068) < 10);
    CHECK(std::abs(peak->time_s - 0.48) < 0.02);
    CHECK(std::abs(motion.back().inlet_psi - 1850) < 8);
    CHECK(std::abs(greatest_slope_psi_per_s(motion) - 2867) < 60);
    double deg_per_s = motion.back().velocity_in_per_s / 22.4 * 180 / std::numbers::pi;
    CHECK(deg_per_s == doctest::Approx(3.96).epsilon(0.01));
}

TEST_CASE("the spool follows its first-order lag") {
    std::vector<BoomState> motion = simulate_boom(BoomScenario());
    const BoomState& state = motion[400]; // t = .2 s, .1 s after the step: 1 - exp(-.8)
    CHECK(state.spool_in == doctest::Approx(0.1297 + 0.1296 * (1 - std::exp(-0.8))).epsilon(1e-9));
}

TEST_CASE("halving the integration step changes the pressure by less than 0.01 psi") {
    BoomScenario fine;
    fine.integration_step_s /= 2;
    std::vector<BoomState> coarse = simulate_boom(BoomScenario()), halved = simulate_boom(fine);
    double greatest = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i)
        greatest = std::max(greatest, std::abs(coarse[i].inlet_psi - halved[2 * i].inlet_psi));
    CHECK(greatest < 0.01);
}

TEST_CASE("a scenario that cannot be simulated says why") {
    BoomScenario scenario;
    scenario.machine.inlet_compliance_in3_per_psi = 0;
    CHECK_THROWS_WITH_AS(simulate_boom(scenario), "boom scenario: the inlet compliance is 0, expected above 0",
                         std::invalid_argument);
}
