#include "hydraulics/circuit/junction_flow.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/moving_excavator.hpp"
#include "hydraulics/plant/moving_record.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "hydraulics/plant/tracking_control.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace placedpar::hydraulics;

namespace {

constexpr double rad = std::numbers::pi / 180;
constexpr ArmLengths arm{205, 95, 55};

JoystickMove move(double seconds, double reach, double height, double pitch_deg, double swing_deg, double soil = 0) {
    return {seconds, {reach, height, pitch_deg * rad, swing_deg * rad}, soil};
}

/// A cycle of digging: lower, crowd against the soil, curl, lift and swing, dump, and crowd while swinging fast.
DigJob cycle() {
    return {"cycle",
            "",
            {300, -20, -60 * rad, 0},
            {move(1, 0, 0, 0, 0), move(2, 0, -20, 0, 0), move(3, -25, 0, -4, 0, 1500), move(2, -10, 10, -15, 0, 1500),
             move(3, 0, 20, 0, 12), move(2, 20, 0, 25, 0), move(1.5, -20, 0, 0, 55, 1500), move(1, 0, 0, 0, 0)}};
}

std::vector<MovingState> motion(const MovingExcavator& machine, const DigJob& job) {
    std::vector<MovingState> states;
    simulate_moving(machine, job, [&](const MovingState& state) { states.push_back(state); });
    return states;
}

JointAngles angles_of(const MovingState& state) {
    JointAngles angles;
    for (std::size_t i = 0; i < angles.size(); ++i)
        angles[i] = state.links[i].angle_rad;
    return angles;
}

/// Returns the pressures at the junctions of the steady flow.
PerLink<double> steady_psi(const MovingState& state, const FlowConstants& flow) {
    PerLink<double> psi{};
    for (LinkSet group : coupled_groups(state.configuration)) {
        const Circuit circuit = circuit_of(state.configuration, group);
        std::vector<JunctionOpening> at;
        for (const Junction& junction : circuit) {
            const MovingLink& link = state.links[index_of(junction.link)];
            at.push_back({link.inlet_psi, link.areas.inlet_in2, link.areas.bypass_in2});
        }
        const std::vector<JunctionFlow> flows = solve_junctions(circuit, at, flow);
        for (std::size_t j = 0; j < circuit.size(); ++j)
            psi[index_of(circuit[j].link)] = flows[j].psi;
    }
    return psi;
}

} // namespace

TEST_CASE("joint_angles() is the inverse of tip_pose() all over the reachable space") {
    int reached = 0;
    for (double reach = -350; reach <= 350; reach += 25)
        for (double height = -300; height <= 300; height += 25)
            for (double pitch = -3; pitch <= 3; pitch += 0.5) {
                auto angles = joint_angles(arm, {reach, height, pitch, 0.3});
                if (!angles)
                    continue;
                ++reached;
                const TipPose back = tip_pose(arm, *angles);
                CHECK(std::hypot(back.reach_in - reach, back.height_in - height) < 1e-9);
                CHECK(std::abs(back.pitch_rad - pitch) < 1e-12);
            }
    CHECK(reached > 4000);
}

TEST_CASE("joint rates move the tip at the given velocity, and joint torques do the work of the force") {
    const TipPose pose{220, -40, -1.2, 0}, velocity{-12, 7, 0.3, 0.1};
    const JointAngles angles = *joint_angles(arm, pose), rates = joint_rates(arm, angles, velocity);
    JointAngles later = angles;
    constexpr double step_s = 1e-6;
    for (std::size_t i = 0; i < later.size(); ++i)
        later[i] += rates[i] * step_s;
    const TipPose moved = tip_pose(arm, later);
    CHECK((moved.reach_in - pose.reach_in) / step_s == doctest::Approx(-12).epsilon(1e-4));
    CHECK((moved.height_in - pose.height_in) / step_s == doctest::Approx(7).epsilon(1e-4));
    CHECK((moved.pitch_rad - pose.pitch_rad) / step_s == doctest::Approx(0.3).epsilon(1e-4));
    const auto torques = joint_torques_lbf_in(arm, angles, 900, -400);
    double power = 0;
    for (std::size_t i = 0; i < rates.size(); ++i)
        power += torques[i] * rates[i];
    CHECK(power == doctest::Approx(900 * -12 + -400 * 7));
}

TEST_CASE("the tip follows its reference while the configuration changes") {
    const MovingExcavator machine = moving_excavator(Parameters::excavator());
    std::string seen;
    double squares = 0;
    const std::vector<MovingState> states = motion(machine, cycle());
    for (const MovingState& state : states) {
        const TipPose tip = tip_pose(machine.arm, angles_of(state));
        squares +=
            std::pow(tip.reach_in - state.asked.reach_in, 2) + std::pow(tip.height_in - state.asked.height_in, 2);
        if (seen.empty() || seen.back() != name_of(state.configuration))
            seen += name_of(state.configuration);
    }
    CHECK(std::sqrt(squares / static_cast<double>(states.size())) < 3);
    for (char each : {'a', 'c', 'd', 'e'})
        CHECK(seen.find(each) != std::string::npos);
    CHECK(seen.size() < 20); // the valves do not chatter
}

TEST_CASE("after their dead time the pilot valves approach each command like exp(-a_0 t)") {
    const MovingExcavator machine = moving_excavator(Parameters::excavator());
    const std::vector<MovingState> states = motion(machine, cycle());
    const DigJob job = cycle();
    TipReference reference(job, machine.joystick_lag_s);
    auto asked = [&](const MovingState& state) {
        PerLink<TrackedLink> now;
        for (std::size_t i = 0; i < now.size(); ++i)
            now[i] = {state.links[i].inlet_psi, state.links[i].angle_rad, state.links[i].rate_rad_per_s};
        const JointAngles angles = *joint_angles(machine.arm, reference.pose());
        return asked_areas(machine, state.configuration, now, angles,
                           joint_rates(machine.arm, angles, reference.velocity()));
    };
    const double lag = machine.links[0].spool_lag_per_s, late = std::exp(-lag * machine.dead_time_s),
                 rest = std::exp(-lag * (machine.control_period_s - machine.dead_time_s));
    PerLink<OrificeAreas> before;
    before.fill({0, machine.bypass_rest_in2, 0});
    double worst = 0, largest = 0;
    for (std::size_t s = 0; s + 1 < states.size(); ++s) {
        const PerLink<OrificeAreas> now = asked(states[s]);
        for (std::size_t i = 0; i < now.size(); ++i) {
            const double start = states[s].links[i].areas.inlet_in2;
            const double middle = before[i].inlet_in2 + (start - before[i].inlet_in2) * late;
            const double end = now[i].inlet_in2 + (middle - now[i].inlet_in2) * rest;
            worst = std::max(worst, std::abs(end - states[s + 1].links[i].areas.inlet_in2));
            largest = std::max(largest, start);
        }
        before = now;
        reference.advance(machine.control_period_s);
    }
    CHECK(largest > 0.05);
    CHECK(worst < 1e-9);
}

TEST_CASE("the pressures at boom and stick are mostly those of the steady circuit") {
    const MovingExcavator machine = moving_excavator(Parameters::excavator());
    std::size_t near = 0, count = 0;
    for (const MovingState& state : motion(machine, cycle())) {
        const PerLink<double> steady = steady_psi(state, machine.valve.flow);
        auto close = [](double a, double b) { return std::abs(a - b) < 25 + 0.05 * b; };
        near += close(state.branch.p13_psi, steady[index_of(Link::boom)]) &&
                close(state.branch.p23_psi, steady[index_of(Link::stick)]);
        ++count;
    }
    CHECK(static_cast<double>(near) > 0.8 * static_cast<double>(count));
}

TEST_CASE("a record without noise holds the motion's readings and its configurations") {
    const MovingExcavator machine = moving_excavator(Parameters::excavator());
    const std::vector<MovingState> states = motion(machine, cycle());
    const Record record = measure_moving(machine, cycle(), no_noise, [] { return 0.5; });
    REQUIRE(record.size() == states.size());
    REQUIRE(record.configuration.size() == states.size());
    CHECK(record.time_s.back() == doctest::Approx(cycle().duration_s()));
    double worst_psi = 0, worst_deg = 0, worst_in2 = 0;
    for (std::size_t s = 0; s < states.size(); ++s) {
        CHECK(record.configuration[s] == name_of(states[s].configuration));
        for (Link link : all_links) {
            const MovingLink& now = states[s].links[index_of(link)];
            auto off = [&](Sensor sensor, double value) { return std::abs(record.of(link, sensor)[s] - value); };
            worst_psi = std::max(worst_psi, off(Sensor::inlet_pressure, now.inlet_psi));
            worst_deg = std::max(worst_deg, off(Sensor::angle, now.angle_rad / rad));
            worst_in2 = std::max({worst_in2, off(Sensor::inlet_area, now.areas.inlet_in2),
                                  off(Sensor::bypass_area, now.areas.bypass_in2)});
        }
    }
    CHECK(worst_psi <= pressure_resolution_psi);
    CHECK(worst_deg <= 2 * angle_resolution_deg);
    CHECK(worst_in2 <= area_resolution_in2);
}

TEST_CASE("half the integration step gives the same motion") {
    MovingExcavator machine = moving_excavator(Parameters::excavator());
    const MovingState coarse = motion(machine, cycle()).back();
    machine.integration_step_s /= 2;
    const MovingState fine = motion(machine, cycle()).back();
    for (std::size_t i = 0; i < fine.links.size(); ++i)
        CHECK(std::abs(coarse.links[i].angle_rad - fine.links[i].angle_rad) < 0.05 * rad);
}

TEST_CASE("a job beyond the arm's reach, or soil that lifts a load, is refused with the number of the move") {
    const MovingExcavator machine = moving_excavator(Parameters::excavator());
    DigJob job = cycle();
    job.moves[2].velocity.reach_in = 60;
    CHECK_THROWS_WITH_AS(motion(machine, job), "move 3: the arm does not reach the tip's path", UnfitScenario);
    job = cycle();
    job.moves[1].soil_lbf = 50000;
    CHECK_THROWS_AS(motion(machine, job), UnfitScenario);
}

TEST_CASE("a controller that is quicker than the pilot valves' dead time is refused") {
    Parameters parameters = Parameters::excavator();
    parameters.set("sensors.period", 0.005);
    CHECK_THROWS_WITH_AS(motion(moving_excavator(parameters), cycle()), doctest::Contains("sensors.period is 0.005 s"),
                         UnfitScenario);
}
