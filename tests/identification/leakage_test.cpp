#include "hydraulics/circuit/leakage.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/compliance_fit.hpp"
#include "tests/nearly.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

constexpr double opening_s = 0.192; // time at which scenario A's load check opens

ExcavatorScenario leaking_boom(double leak_in3_per_s_psi, double start_s = opening_s) {
    ExcavatorScenario scenario = single_boom_scenario();
    scenario.links[0].leak = {leak_in3_per_s_psi, start_s};
    return scenario;
}

std::vector<CircuitSample> rising_samples(const ExcavatorScenario& scenario) {
    Record measured =
        measure_excavator(simulate_excavator(scenario), scenario, sampling_period_s, no_noise, [] { return 0.0; });
    UsableSamples rising;
    rising.count = 13;
    return usable_samples(circuit_samples(measured, boom_circuit(), boom_calibrations(scenario.links[0].mechanics)),
                          boom_circuit(), scenario.flow, rising);
}

/// Returns the compliance with the least error in a model without a leak.
double identified_compliance(const ExcavatorScenario& scenario) {
    std::array start{0.0086};
    return fit_compliances(boom_circuit(), rising_samples(scenario), scenario.flow, start)->compliance_in3_per_psi[0];
}

/// The leak flow and the pressure slope of the true motion, at the sampling times of the rise, .20 to .44 s.
struct Rise {
    std::vector<double> leak_in3_per_s, slope_psi_per_s;
};

Rise rise_of(const ExcavatorScenario& scenario) {
    auto motion = simulate_excavator(scenario).states;
    Rise rise;
    for (std::size_t i = 400; i <= 880; i += 40) {
        const LinkState& boom = motion[i].links[0];
        rise.leak_in3_per_s.push_back(
            leakage_in3_per_s(scenario.links[0].leak.in3_per_s_psi, boom.inlet_psi, boom.outlet_psi));
        rise.slope_psi_per_s.push_back((motion[i + 1].links[0].inlet_psi - motion[i - 1].links[0].inlet_psi) /
                                       (2 * scenario.integration_step_s));
    }
    return rise;
}

double steepest_psi_per_s(const ExcavatorScenario& scenario) {
    double steepest = 0;
    for (const CircuitSample& sample : rising_samples(scenario))
        steepest = std::max(steepest, sample.links[0].inlet_slope_psi_per_s);
    return steepest;
}

} // namespace

TEST_CASE("the apparent compliance of a leak agrees with a hand computation") {
    CHECK(leakage_in3_per_s(0.002, 1900, 100) == doctest::Approx(3.6));
    std::array leak{2.0, 4.0}, slope{1000.0, 2000.0};
    CHECK(apparent_compliance_change(leak, slope) == test::nearly(0.002)); // (2e3 + 8e3) / 5e6
    std::array flat{0.0, 0.0};
    CHECK_THROWS_AS(apparent_compliance_change(leak, flat), std::invalid_argument);
    CHECK_THROWS_AS(apparent_compliance_change(std::span(leak).first(1), slope), std::invalid_argument);
}

TEST_CASE("a leak that starts with the motion has the predicted flow and apparent compliance") {
    struct Figures {
        double leak_in3_per_s_psi, flow_in3_per_s, change_in3_per_psi;
    };
    double sound = identified_compliance(leaking_boom(0));
    CHECK(sound == test::nearly(0.0086, 0.02));
    for (const Figures& figures : {Figures{0.001, 1.82, 0.00079}, {0.002, 3.60, 0.00159}, {0.004, 6.97, 0.0032}}) {
        double leak = figures.leak_in3_per_s_psi;
        CAPTURE(leak);
        Rise rise = rise_of(leaking_boom(leak));
        double predicted = apparent_compliance_change(rise.leak_in3_per_s, rise.slope_psi_per_s);
        CHECK(std::abs(mean(rise.leak_in3_per_s) - figures.flow_in3_per_s) < 0.04 * figures.flow_in3_per_s);
        CHECK(std::abs(predicted - figures.change_in3_per_psi) < 0.03 * figures.change_in3_per_psi);
        double ratio = mean(rise.leak_in3_per_s) / mean(rise.slope_psi_per_s) / predicted;
        CHECK(ratio > 0.9);
        CHECK(ratio < 1.2);
        double found = identified_compliance(leaking_boom(leak)) - sound;
        CHECK(std::abs(found - predicted) < 0.06 * predicted);
    }
}

TEST_CASE("the premise of 2.8, a slower rise with the leak, holds only if the leak starts with the motion") {
    double sound = steepest_psi_per_s(leaking_boom(0));
    CHECK(steepest_psi_per_s(leaking_boom(0.002)) < sound);
    CHECK(steepest_psi_per_s(leaking_boom(0.002, 0)) > sound); // the leak has lowered the held pressure before
}

TEST_CASE("the flow of a leak leaves one side and enters the other") {
    ExcavatorScenario scenario = single_boom_scenario();
    scenario.links[0].valve = SpoolOrifices{0.1297, {}}; // the valve holds the link, with both sides shut
    scenario.links[0].leak = {0.002, 0.05};
    scenario.links[0].mechanics.friction_lbf = 1e6; // the piston is stuck as well
    scenario.duration_s = 0.2;
    auto motion = simulate_excavator(scenario);
    auto volume = [&](const ExcavatorState& state) {
        const LinkMechanics& boom = scenario.links[0].mechanics;
        const LinkState& link = state.links[0];
        return boom.inlet_compliance_in3_per_psi * link.inlet_psi + boom.inlet_area_in2 * link.piston_in +
               boom.outlet_compliance_in3_per_psi * link.outlet_psi - boom.outlet_area_in2 * link.piston_in;
    };
    const LinkState &start = motion.states.front().links[0], &end = motion.states.back().links[0];
    CHECK(motion.states[100].links[0].inlet_psi == doctest::Approx(start.inlet_psi).epsilon(1e-12)); // .05 s
    CHECK(end.inlet_psi < start.inlet_psi - 20);
    CHECK(end.outlet_psi > start.outlet_psi + 20);
    CHECK(volume(motion.states.back()) == doctest::Approx(volume(motion.states.front())).epsilon(1e-9));
}
