#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/requirement.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

const ExcavatorMotion& two_links() {
    static const ExcavatorMotion motion = simulate_excavator(two_link_scenario());
    return motion;
}

const LinkState& at(const ExcavatorMotion& motion, double time_s, std::size_t link) {
    double step_s = motion.states[1].time_s;
    return motion.states[static_cast<std::size_t>(std::lround(time_s / step_s))].links[link];
}

/// Returns the peak pressure at the instants that are multiples of 4 ms, so that motions of different steps can be
/// compared.
double peak_psi(const ExcavatorMotion& motion, std::size_t link) {
    auto stride = static_cast<std::size_t>(std::lround(0.004 / motion.states[1].time_s));
    double peak = 0;
    for (std::size_t i = 0; i < motion.states.size(); i += stride)
        peak = std::max(peak, motion.states[i].links[link].inlet_psi);
    return peak;
}

/// Returns the root mean square of dP/dt over a window of 10 samples of 20 ms, from differences of the motion.
double excitation_psi_per_s(const ExcavatorMotion& motion, double time_s, std::size_t link) {
    double sum = 0;
    for (int w = 0; w < 10; ++w) {
        double middle_s = time_s - 0.02 * w, step_s = motion.states[1].time_s;
        double slope = (at(motion, middle_s + step_s, link).inlet_psi - at(motion, middle_s - step_s, link).inlet_psi) /
                       (2 * step_s);
        sum += slope * slope;
    }
    return std::sqrt(sum / 10);
}

/// Returns the greatest difference in any inlet pressure between a motion and the motion with half its step.
double difference_psi(const ExcavatorMotion& coarse, const ExcavatorMotion& halved) {
    double greatest = 0;
    for (std::size_t i = 0; i < coarse.states.size(); ++i)
        for (std::size_t link = 0; link < coarse.states[i].links.size(); ++link)
            greatest = std::max(greatest, std::abs(coarse.states[i].links[link].inlet_psi -
                                                   halved.states[2 * i].links[link].inlet_psi));
    return greatest;
}

ExcavatorMotion with_step(ExcavatorScenario scenario, double step_s) {
    scenario.integration_step_s = step_s;
    scenario.duration_s = 1.2;
    return simulate_excavator(scenario);
}

} // namespace

TEST_CASE("scenario R2 has its known steady state") {
    const LinkState &bucket = at(two_links(), 4, 0), &boom = at(two_links(), 4, 1);
    CHECK(std::abs(bucket.flow.inlet_in3_per_s - 51.9) < 0.05);
    CHECK(std::abs(bucket.flow.bypass_in3_per_s - 123.2) < 0.05);
    CHECK(std::abs(boom.flow.inlet_in3_per_s - 57.2) < 0.05);
    CHECK(std::abs(boom.flow.bypass_in3_per_s - 66.0) < 0.05);
    CHECK(std::abs(bucket.flow.psi - 2051) < 1);
    CHECK(std::abs(boom.flow.psi - 1722) < 1);
    CHECK(std::abs(bucket.inlet_psi - 2024) < 1);
    CHECK(std::abs(boom.inlet_psi - 1687) < 1);
    // The forces balance: A P = F + b v, and all flow into the link moves it.
    CHECK(20 * bucket.inlet_psi == doctest::Approx(34000 + 2500 * bucket.velocity_in_per_s).epsilon(1e-5));
    CHECK(bucket.flow.inlet_in3_per_s == doctest::Approx(20 * bucket.velocity_in_per_s).epsilon(1e-4));
}

TEST_CASE("in scenario R2 both paths are open from .34 s on, and excitation ends by 1.0 and 1.42 s") {
    const auto& checks = two_links().checks;
    REQUIRE(checks.size() == 2); // each opens once and never shuts
    CHECK(checks[0].link == Link::bucket);
    CHECK(checks[1].link == Link::boom);
    CHECK(checks[0].opened);
    CHECK(checks[1].opened);
    CHECK(checks[1].time_s > 0.32);
    CHECK(checks[1].time_s < 0.34);
    CHECK(excitation_psi_per_s(two_links(), 0.7, 0) > 700);
    CHECK(excitation_psi_per_s(two_links(), 1.04, 0) < 200);
    CHECK(excitation_psi_per_s(two_links(), 1.08, 1) < 200);
    CHECK(excitation_psi_per_s(two_links(), 0.98, 0) > 200);
    CHECK(excitation_psi_per_s(two_links(), 1.42, 0) < 25);
    CHECK(excitation_psi_per_s(two_links(), 1.60, 1) < 25);
}

TEST_CASE("in scenario R2 the first opening agrees with its closed form") {
    // All of Q passes both bypasses: P11 = P_e + (Q/k)^2 (a_ebu^-2 + a_ebo^-2), which is 1700 psi when the bucket
    // opens.
    double low = 0, high = 1;
    for (int i = 0; i < 100; ++i) {
        double middle = (low + high) / 2, gone = std::exp(-8 * middle);
        double bucket = (0.30 - 0.068) * gone + 0.068, boom = (0.30 - 0.016) * gone + 0.016;
        double psi = 16.2 + std::pow(175.08 / 99.83, 2) * (1 / (bucket * bucket) + 1 / (boom * boom));
        (psi < 1700 ? low : high) = middle;
    }
    CHECK(std::abs(two_links().checks[0].time_s - low) < 1e-8);
}

TEST_CASE(
    "in scenario R2, halving the step divides the pressure's error by 16, as order 4 requires, through both openings") {
    // With steps that did not stop at the openings, the difference would be .05 psi instead of .001, and the ratio 2.
    ExcavatorMotion steps_4_ms = with_step(two_link_scenario(), 0.004),
                    steps_2_ms = with_step(two_link_scenario(), 0.002),
                    steps_1_ms = with_step(two_link_scenario(), 0.001);
    double coarse = difference_psi(steps_4_ms, steps_2_ms), fine = difference_psi(steps_2_ms, steps_1_ms);
    CHECK(coarse < 1e-3);
    CHECK(coarse / fine > 12);
    CHECK(coarse / fine < 24);
    CHECK(std::abs(peak_psi(steps_4_ms, 0) - peak_psi(steps_2_ms, 0)) < 1e-3);
    CHECK(std::abs(peak_psi(steps_4_ms, 1) - peak_psi(steps_2_ms, 1)) < 1e-3);
    REQUIRE(steps_4_ms.checks.size() == steps_2_ms.checks.size());
    for (std::size_t i = 0; i < steps_4_ms.checks.size(); ++i)
        CHECK(std::abs(steps_4_ms.checks[i].time_s - steps_2_ms.checks[i].time_s) < 2e-8);
}

TEST_CASE("the boom alone keeps order 4 through the spool's knees and the opening") {
    ExcavatorMotion steps_4_ms = with_step(single_boom_scenario(), 0.004),
                    steps_2_ms = with_step(single_boom_scenario(), 0.002),
                    steps_1_ms = with_step(single_boom_scenario(), 0.001);
    double coarse = difference_psi(steps_4_ms, steps_2_ms), fine = difference_psi(steps_2_ms, steps_1_ms);
    CHECK(coarse < 2e-4);
    CHECK(coarse / fine > 12);
    CHECK(std::abs(steps_4_ms.checks.at(0).time_s - steps_2_ms.checks.at(0).time_s) < 2e-9);
}

TEST_CASE("in scenario A the check valve opens at .192 s") {
    ExcavatorMotion motion = simulate_excavator(single_boom_scenario());
    REQUIRE(motion.checks.size() == 1);
    CHECK(std::abs(motion.checks[0].time_s - 0.192) < 5e-4);
}

TEST_CASE("a ramp of the spool's command agrees with its closed form for any step") {
    // During the ramp a' = a_0 (rest + r t - a), so a = rest + r (t - (1 - exp(-a_0 t)) / a_0).
    ExcavatorScenario scenario = single_boom_scenario();
    auto& valve = std::get<SpoolOrifices>(scenario.links[0].valve);
    valve.steps = {{0.1003, 0.2297, 0.5}};
    scenario.integration_step_s = 0.002;
    ExcavatorMotion motion = simulate_excavator(scenario);
    double rate = (0.2297 - valve.rest_in) / 0.5, gone_s = 0.4 - 0.1003;
    CHECK(at(motion, 0.1, 0).spool_in == valve.rest_in);
    CHECK(at(motion, 0.4, 0).spool_in ==
          doctest::Approx(valve.rest_in + rate * (gone_s - (1 - std::exp(-8 * gone_s)) / 8)).epsilon(1e-9));
    double lag_in = rate * (1 - std::exp(-8 * 0.5)) / 8; // behind the command when the ramp ends
    CHECK(at(motion, 1, 0).spool_in == doctest::Approx(0.2297 - lag_in * std::exp(-8 * (1 - 0.6003))).epsilon(1e-9));
}

TEST_CASE("in any configuration each link gets and keeps the flow that the controller asks for") {
    for (Configuration configuration : all_configurations) {
        CAPTURE(std::string(1, name_of(configuration)));
        ExcavatorScenario scenario = step_scenario(configuration, LinkSet::all());
        scenario.integration_step_s = 0.008;
        ExcavatorMotion motion = simulate_excavator(scenario);
        for (std::size_t i = 0; i < 4; ++i) {
            Link link = scenario.links[i].link;
            CAPTURE(name_of(link));
            bool alone = (configuration == Configuration::b && link == Link::bucket) ||
                         (configuration == Configuration::c && link == Link::swing);
            double expected = alone ? 175.08 : 50;
            const LinkState& end = motion.states.back().links[i];
            CHECK(end.flow.inlet_in3_per_s == doctest::Approx(expected).epsilon(1e-3));
            CHECK(end.velocity_in_per_s * coupled_mechanics(link).inlet_area_in2 ==
                  doctest::Approx(expected).epsilon(0.02));
            CHECK(end.flow.relief_in3_per_s == 0);
        }
    }
}

TEST_CASE("the branches are independent in configuration a and coupled in d") {
    for (Configuration configuration : {Configuration::a, Configuration::d}) {
        ExcavatorScenario both = step_scenario(configuration, LinkSet::all());
        both.duration_s = 0.5;
        both.integration_step_s = 0.004;
        ExcavatorScenario heavier = both;
        heavier.links[3].mechanics.load_lbf *= 1.1; // the swing
        ExcavatorMotion before = simulate_excavator(both), behind = simulate_excavator(heavier);
        double change = std::abs(before.states.back().links[1].inlet_psi - behind.states.back().links[1].inlet_psi);
        if (configuration == Configuration::a)
            CHECK(change < 1e-4); // steps end at other times when the swing's check valve opens later
        else
            CHECK(change > 1);
    }
}

TEST_CASE("the check valve holds a load that exceeds the pump's pressure") {
    ExcavatorScenario scenario = single_boom_scenario();
    auto& valve = std::get<SpoolOrifices>(scenario.links[0].valve);
    valve.steps.push_back({0.6, 0.1297}); // back to rest: the check valve must shut
    ExcavatorMotion motion = simulate_excavator(scenario);
    REQUIRE(motion.checks.size() == 2);
    CHECK(motion.checks[0].opened);
    CHECK(!motion.checks[1].opened);
    CHECK(motion.checks[1].time_s > 0.6);
    for (const ExcavatorState& state : motion.states)
        CHECK(state.links[0].flow.inlet_in3_per_s >= 0);
    CHECK(motion.states.back().links[0].flow.inlet_in3_per_s == 0);
}

TEST_CASE("an impossible scenario is refused with the reason") {
    ExcavatorScenario scenario = two_link_scenario();
    scenario.links[1].mechanics.mass_lbf_s2_per_in = 0;
    CHECK_THROWS_WITH_AS(simulate_excavator(scenario), "excavator scenario: the boom's mass is 0, expected above 0",
                         UnfitScenario);
    scenario = two_link_scenario();
    scenario.links[0].mechanics.damping_lbf_s_per_in = -1;
    CHECK_THROWS_WITH_AS(simulate_excavator(scenario),
                         "excavator scenario: the bucket's damping is -1, expected 0 or above", UnfitScenario);
    scenario = two_link_scenario();
    scenario.links[1].link = Link::bucket;
    CHECK_THROWS_WITH_AS(simulate_excavator(scenario),
                         "excavator scenario: the bucket is listed twice, expected each link once", UnfitScenario);
    scenario.links.clear();
    CHECK_THROWS_WITH_AS(simulate_excavator(scenario), "excavator scenario: no link is active, expected at least one",
                         UnfitScenario);
    scenario = single_boom_scenario();
    std::get<SpoolOrifices>(scenario.links[0].valve).steps.push_back({0.05, 0.2});
    CHECK_THROWS_WITH_AS(
        simulate_excavator(scenario),
        "excavator scenario: the boom's step time is 0.05, expected a time after the end of the previous step",
        UnfitScenario);
}
