#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/flow_split.hpp"
#include "hydraulics/plant/excavator_motion.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/measured_dynamics.hpp"
#include "hydraulics/plant/measured_motion.hpp"
#include "hydraulics/plant/requirement.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

/// Returns the measured excavator reduced to the simple model plus hoses and friction.
MeasuredExcavator plain_excavator() {
    MeasuredExcavator excavator = measured_excavator();
    excavator.ripple.amplitude = 0;
    excavator.inlet_hose.resistance_psi_s_per_in3 = excavator.outlet_hose.resistance_psi_s_per_in3 = 0;
    excavator.dead_time_s = 0;
    excavator.servo_converter.bits = 0;
    excavator.command.desired_volts = servo_volts(0.2593);
    return excavator;
}

void take_friction_away(MeasuredExcavator& excavator) {
    excavator.friction.coulomb_lbf = excavator.friction.breakaway_lbf = 0;
}

/// Makes the piston immovable.
void lock(MeasuredExcavator& excavator) {
    excavator.friction.coulomb_lbf = excavator.friction.breakaway_lbf = 1e6;
    excavator.friction.bristle_stiffness_lbf_per_in = 2e9;
    excavator.friction.bristle_damping_lbf_s_per_in = 2e6;
    excavator.integration_step_s = 5e-5;
}

/// Returns the mean of a quantity over the last `share` of a motion.
double last_mean(const std::vector<MeasuredState>& motion, double MeasuredState::*quantity, double share) {
    auto count = static_cast<std::size_t>(share * static_cast<double>(motion.size()));
    double sum = 0;
    for (std::size_t i = motion.size() - count; i < motion.size(); ++i)
        sum += motion[i].*quantity;
    return sum / static_cast<double>(count);
}

} // namespace

TEST_CASE("the steady motion of the measured machine equals the simple plant's") {
    MeasuredExcavator excavator = plain_excavator();
    excavator.duration_s = 8;
    ExcavatorScenario simple = single_boom_scenario();
    simple.duration_s = 8;
    MeasuredState rich = simulate_measured_excavator(excavator).back();
    LinkState plain = simulate_excavator(simple).states.back().links[0];
    CHECK(rich.inlet_psi == doctest::Approx(plain.inlet_psi).epsilon(1e-4));
    CHECK(rich.inlet_psi == doctest::Approx(1850).epsilon(0.005));
    CHECK(rich.outlet_psi == doctest::Approx(plain.outlet_psi).epsilon(1e-3));
    CHECK(rich.velocity_in_per_s == doctest::Approx(plain.velocity_in_per_s).epsilon(1e-4));
    CHECK(rich.spool_in == doctest::Approx(plain.spool_in).epsilon(1e-9));
}

TEST_CASE("with stiff hoses and no friction the transient equals the simple plant's") {
    MeasuredExcavator excavator = plain_excavator();
    excavator.inlet_hose.inertance_psi_s2_per_in3 = excavator.outlet_hose.inertance_psi_s2_per_in3 = 2e-4;
    take_friction_away(excavator);
    ExcavatorScenario simple = single_boom_scenario();
    simple.links[0].mechanics.friction_lbf = 0;
    simple.duration_s = excavator.duration_s;
    std::vector<MeasuredState> rich = simulate_measured_excavator(excavator);
    std::vector<ExcavatorState> plain = simulate_excavator(simple).states;
    double greatest = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) // steps of .5 and .1 ms
        greatest = std::max(greatest, std::abs(rich.at(5 * i).inlet_psi - plain[i].links[0].inlet_psi));
    CHECK(greatest < 4); // the rise is 500 psi
    CHECK(greatest > 0);
}

TEST_CASE("the pump's flow equals the sum of its parts, and the flow into the cylinder moves the piston") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.duration_s = 8;
    excavator.leak.in3_per_s_psi = 0.002;
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    for (std::size_t i = 0; i < motion.size(); i += 97)
        CHECK(motion[i].inlet_in3_per_s + motion[i].bypass_in3_per_s ==
              doctest::Approx(motion[i].pump_in3_per_s).epsilon(1e-9));
    double piston = excavator.boom.inlet_area_in2 * last_mean(motion, &MeasuredState::velocity_in_per_s, 0.1);
    double leak = last_mean(motion, &MeasuredState::leak_in3_per_s, 0.1);
    CHECK(last_mean(motion, &MeasuredState::inlet_in3_per_s, 0.1) == doctest::Approx(piston + leak).epsilon(1e-3));
    CHECK(last_mean(motion, &MeasuredState::inlet_hose_in3_per_s, 0.1) == doctest::Approx(piston + leak).epsilon(1e-3));
    CHECK(leak == doctest::Approx(0.002 * (last_mean(motion, &MeasuredState::inlet_cylinder_psi, 0.1) -
                                           last_mean(motion, &MeasuredState::outlet_cylinder_psi, 0.1))));
    // The hose's resistance is .25 psi s/in^3.
    CHECK(last_mean(motion, &MeasuredState::inlet_psi, 0.1) -
              last_mean(motion, &MeasuredState::inlet_cylinder_psi, 0.1) ==
          doctest::Approx(0.25 * (piston + leak)).epsilon(1e-2));
}

TEST_CASE("a leak starts at its time and slows the boom") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.duration_s = 6;
    double tight = simulate_measured_excavator(excavator).back().velocity_in_per_s;
    excavator.leak.in3_per_s_psi = 0.004;
    excavator.leak.start_s = 2.005;
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    CHECK(motion.at(20000).leak_in3_per_s == 0);
    // k_l times a pressure difference of about 1740 psi is 6.97.
    CHECK(motion.at(20060).leak_in3_per_s == doctest::Approx(6.9).epsilon(0.05));
    CHECK(motion.back().velocity_in_per_s < 0.95 * tight);
}

TEST_CASE("the pump's ripple reaches the sensor through the valve, the hose and the cylinder") {
    MeasuredExcavator excavator = plain_excavator();
    excavator.duration_s = 7;
    excavator.inlet_hose.resistance_psi_s_per_in3 = 0.25;
    take_friction_away(excavator);
    const MeasuredState smooth = simulate_measured_excavator(excavator).back();
    OrificeAreas areas = boom_orifices(smooth.spool_in);
    auto inlet_at = [&](double psi, double pump) {
        FlowConstants flow = excavator.flow;
        flow.pump_in3_per_s = pump;
        return split_flow(areas.inlet_in2, areas.bypass_in2, psi, flow).inlet_in3_per_s;
    };
    double psi = smooth.inlet_psi, pump = excavator.flow.pump_in3_per_s;
    double by_pump = (inlet_at(psi, pump + 0.01) - inlet_at(psi, pump - 0.01)) / 0.02;
    double by_psi = (inlet_at(psi - 0.1, pump) - inlet_at(psi + 0.1, pump)) / 0.2;
    excavator.ripple.amplitude = 0.002;
    for (double frequency : {15.0, 34.0, 60.0, 270.0}) {
        excavator.ripple.frequency_per_s = frequency;
        const std::complex<double> jw(0, 2 * std::numbers::pi * frequency);
        HoseEnds ends = ends_of(excavator.inlet_hose, excavator.boom.inlet_compliance_in3_per_psi);
        std::complex<double> piston = 32.0 * 32.0 / (1000.0 * jw + 800.0);
        std::complex<double> line = 0.25 + jw * 0.01215 + 1.0 / (jw * ends.cylinder_in3_per_psi + piston);
        double expected = std::abs(by_pump * 0.002 * pump / (by_psi + jw * ends.valve_in3_per_psi + 1.0 / line));
        std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
        double least = psi, most = psi;
        for (std::size_t i = motion.size() - 5000; i < motion.size(); ++i) {
            least = std::min(least, motion[i].inlet_psi);
            most = std::max(most, motion[i].inlet_psi);
        }
        CAPTURE(frequency);
        CHECK((most - least) / 2 == doctest::Approx(expected).epsilon(0.03));
    }
}

TEST_CASE("below the break-away force the piston does not move") {
    MeasuredExcavator excavator = plain_excavator();
    double held = simulate_measured_excavator(excavator).front().inlet_psi;
    CHECK(held == doctest::Approx(1555.5).epsilon(1e-3));
    excavator.duration_s = 3;
    excavator.flow.relief_psi = held + 200; // 6400 lbf more than gravity; the break-away force is 7800 lbf
    const MeasuredState stuck = simulate_measured_excavator(excavator).back();
    CHECK(stuck.inlet_cylinder_psi == doctest::Approx(held + 200).epsilon(1e-3));
    CHECK(std::abs(stuck.velocity_in_per_s) < 1e-3);
    CHECK(std::abs(stuck.piston_in) < 0.01); // the bristles deflect, and creep while the hose rings
    excavator.flow.relief_psi = held + 300;  // 9600 lbf
    CHECK(simulate_measured_excavator(excavator).back().piston_in > 0.5);
}

TEST_CASE("free air gives the inlet side the stiffness of the mixture") {
    MeasuredExcavator excavator = plain_excavator();
    lock(excavator);
    excavator.duration_s = 0.8;
    excavator.oil.air_fraction = 0.05;
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    double fed = 0, taken_up = 0;
    for (std::size_t i = 1; i < motion.size(); ++i) {
        const MeasuredState &a = motion[i - 1], &b = motion[i];
        double psia = (a.inlet_cylinder_psi + b.inlet_cylinder_psi) / 2 + 14.7;
        // beta = B0 (R + z) / (R + B0 z / P), with R = 19 and z = 14.7 / P
        double z = 14.7 / psia, beta = 220e3 * (19 + z) / (19 + 220e3 * z / psia);
        double softness = 0.7 * 0.0086 + 946 / beta - 946 / 220e3;
        fed += (a.inlet_in3_per_s + b.inlet_in3_per_s) / 2 * (b.time_s - a.time_s);
        taken_up +=
            softness * (b.inlet_cylinder_psi - a.inlet_cylinder_psi) + 0.3 * 0.0086 * (b.inlet_psi - a.inlet_psi);
    }
    CHECK(motion.back().inlet_psi > 2000);
    CHECK(taken_up == doctest::Approx(fed).epsilon(2e-3));
}

TEST_CASE("the spool has a dead time, a lag, and an offset common to voltage and sensor") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.command.desired_volts = 0.34;
    excavator.voltage_spool.spool_in.at_start = -0.01; // the sensor and A.1 both read .01 in too high
    std::vector<MeasuredState> motion = simulate_measured_excavator(excavator);
    double rest = 0.1297 - 0.01, volts = std::nearbyint(0.34 / (20.0 / 4096)) * (20.0 / 4096);
    CHECK(motion.at(1100).spool_in == doctest::Approx(rest).epsilon(1e-12)); // step .1 s, dead time .01 s
    double reached = motion.at(2100).spool_in - rest;
    double asked = ((0.0892 * volts + 0.2352) * volts + 0.2815) * volts;
    CHECK(reached == doctest::Approx(asked * (1 - std::exp(-0.8))).epsilon(1e-8));
}

TEST_CASE("the voltage is held from one sampling instant to the next, in the converter's steps") {
    MeasuredExcavator excavator = measured_excavator();
    excavator.command.ramp_s = 0.5;
    for (double time_s = 0; time_s < 0.7; time_s += 0.0007) {
        double volts = held_volts(excavator, time_s), step = 20.0 / 4096;
        CHECK(volts / step == std::round(volts / step));
        CHECK(volts == held_volts(excavator, (std::floor(time_s / 0.02 + 1e-6) + 0.5) * 0.02));
    }
    CHECK(std::abs(held_volts(excavator, 0.6) - 0.3467) <= 10.0 / 4096);
    CHECK(held_volts(excavator, 0.1) == 0);
    excavator.command.second_time_s = 0.65;
    excavator.command.second_volts = 100;
    CHECK(held_volts(excavator, 0.66) == 10 - 20.0 / 4096); // the end of the converter's range
}

TEST_CASE("halving the step divides the measured machine's pressure error by 16, through the opening and the knees") {
    auto with_step = [](double step_s) {
        MeasuredExcavator excavator = measured_excavator();
        excavator.duration_s = 0.6;
        excavator.integration_step_s = step_s;
        return simulate_measured_excavator(excavator);
    };
    auto difference_psi = [](const std::vector<MeasuredState>& coarse, const std::vector<MeasuredState>& halved) {
        double greatest = 0;
        for (std::size_t i = 0; i < coarse.size(); ++i)
            greatest = std::max(greatest, std::abs(coarse[i].inlet_psi - halved[2 * i].inlet_psi));
        return greatest;
    };
    auto coarse = with_step(2e-4), halved = with_step(1e-4), fine = with_step(5e-5);
    double first = difference_psi(coarse, halved), second = difference_psi(halved, fine);
    CHECK(first < 5e-5);
    CHECK(first / second > 12);
    CHECK(first / second < 24);
}

TEST_CASE("an impossible excavator is refused with the reason") {
    auto refusal = [](auto change) -> std::string {
        MeasuredExcavator excavator = measured_excavator();
        change(excavator);
        try {
            simulate_measured_excavator(excavator);
        } catch (const UnfitScenario& error) {
            return error.what();
        }
        return "none";
    };
    CHECK(refusal([](auto& m) { m.boom.inlet_compliance_in3_per_psi = 0; }) ==
          "measured machine: the inlet compliance is 0, expected above 0");
    CHECK(refusal([](auto& m) { m.inlet_hose.valve_share = 1; }) ==
          "measured machine: the valve's share of the inlet compliance is 1, expected above 0 and below 1");
    CHECK(
        refusal([](auto& m) { m.integration_step_s = 0.005; }) ==
        "measured machine: the integration step is 0.005, expected at most 0.00234 s for the inlet hose's oscillation");
    CHECK(refusal([](auto& m) { m.friction.breakaway_lbf = 5000; }) ==
          "measured machine: the break-away force is 5000, expected at least the friction of 6000 lbf");
    CHECK(refusal([](auto& m) { m.duration_s = 1e9; }) ==
          "measured machine: the duration is 1000000000 s, expected at most 200 s, which are 2000000 integration steps "
          "of 0.0001 s");
    CHECK(refusal([](auto& m) { m.oil.air_fraction = 1; }).starts_with("measured machine: the air fraction is 1"));
    CHECK(refusal([](auto& m) { m.command.desired_volts = std::nan(""); }).find("servo voltage") != std::string::npos);
}
