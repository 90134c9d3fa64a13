#include "hydraulics/plant/excavator_values.hpp"

#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "hydraulics/plant/requirement.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

/// The state of the only link in a motion of the boom alone, and its time.
struct BoomState : LinkState {
    double time_s;
};

std::vector<BoomState> simulate_boom(const ExcavatorScenario& scenario) {
    std::vector<BoomState> motion;
    for (const ExcavatorState& state : simulate_excavator(scenario).states)
        motion.push_back({state.links.at(0), state.time_s});
    return motion;
}

ExcavatorScenario long_scenario() {
    ExcavatorScenario scenario = single_boom_scenario();
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

std::vector<BoomState> with_step(const char* name, double step_s) {
    ExcavatorScenario scenario = single_boom_scenario(Parameters::excavator(), name);
    scenario.integration_step_s = step_s;
    scenario.duration_s = 1.2;
    return simulate_boom(scenario);
}

/// Returns the greatest difference in the inlet pressure between a motion and the motion with half its step.
double difference_psi(const std::vector<BoomState>& coarse, const std::vector<BoomState>& halved) {
    double greatest = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i)
        greatest = std::max(greatest, std::abs(coarse[i].inlet_psi - halved[2 * i].inlet_psi));
    return greatest;
}

} // namespace

TEST_CASE("in scenario A the load is held until the spool moves") {
    std::vector<BoomState> motion = simulate_boom(single_boom_scenario());
    CHECK(motion.front().inlet_psi == doctest::Approx(1555).epsilon(1e-3));
    const BoomState& before = motion[200];
    CHECK(before.time_s == doctest::Approx(0.1));
    CHECK(std::abs(before.piston_in) < 1e-6);
    CHECK(before.inlet_psi == doctest::Approx(motion.front().inlet_psi).epsilon(1e-9));
}

TEST_CASE("scenario A has its known peak, steady state and steepest rise") {
    std::vector<BoomState> motion = simulate_boom(long_scenario());
    auto peak = std::max_element(motion.begin(), motion.end(),
                                 [](const BoomState& a, const BoomState& b) { return a.inlet_psi < b.inlet_psi; });
    CHECK(std::abs(peak->inlet_psi - 2069.2) < 0.1);
    CHECK(std::abs(peak->time_s - 0.471) < 0.001);
    auto trough = std::min_element(peak, motion.end(),
                                   [](const BoomState& a, const BoomState& b) { return a.inlet_psi < b.inlet_psi; });
    CHECK(std::abs(trough->inlet_psi - 1792) < 1);
    CHECK(std::abs(motion.back().inlet_psi - 1850) < 8);
    CHECK(std::abs(greatest_slope_psi_per_s(motion) - 2867) < 1);
    double deg_per_s = motion.back().velocity_in_per_s / 22.4 * 180 / std::numbers::pi;
    CHECK(deg_per_s == doctest::Approx(3.96).epsilon(0.01));
}

TEST_CASE("the spool follows its first-order lag") {
    std::vector<BoomState> motion = simulate_boom(single_boom_scenario());
    const BoomState& state = motion[400]; // t = .2 s, .1 s after the step: 1 - exp(-.8)
    CHECK(state.spool_in == doctest::Approx(0.1297 + 0.1296 * (1 - std::exp(-0.8))).epsilon(1e-9));
}

TEST_CASE("halving the step divides the simple plant's pressure error by 16, through the opening and the knees") {
    // With steps that did not stop at the events, the difference would be .02 psi, and the ratio 2 to 4.
    for (const char* name : {"scenario_a", "scenario_b"}) {
        CAPTURE(name);
        auto coarse = with_step(name, 0.004), halved = with_step(name, 0.002), fine = with_step(name, 0.001);
        double first = difference_psi(coarse, halved), second = difference_psi(halved, fine);
        CHECK(first < 2e-4);
        CHECK(first / second > 12);
        CHECK(first / second < 24);
    }
}

TEST_CASE("scenario B rises from 1524 to 2070 psi in .52 s and settles at 1835 psi") {
    Parameters parameters = record_scenario_named("scenario-b")->parameters(Parameters::excavator());
    ExcavatorScenario scenario = single_boom_scenario(parameters, "scenario_b");
    scenario.duration_s = 6;
    std::vector<BoomState> motion = simulate_boom(scenario);
    CHECK(motion.front().inlet_psi == doctest::Approx(1524).epsilon(1e-3));
    auto peak = std::ranges::max_element(motion, {}, &BoomState::inlet_psi);
    CHECK(std::abs(peak->inlet_psi - 2070) < 5);
    CHECK(std::abs(motion.back().inlet_psi - 1835) < 8);
    auto rises = std::ranges::find_if(motion, [&](const BoomState& state) {
        return state.inlet_psi > motion.front().inlet_psi + 5; // a hundredth of the rise
    });
    CHECK(std::abs(peak->time_s - rises->time_s - 0.52) < 0.05);
}

TEST_CASE("an impossible scenario of the boom is refused with the reason") {
    ExcavatorScenario scenario = single_boom_scenario();
    scenario.links[0].mechanics.inlet_compliance_in3_per_psi = 0;
    CHECK_THROWS_WITH_AS(simulate_boom(scenario),
                         "excavator scenario: the boom's inlet compliance is 0, expected above 0", UnfitScenario);
}
