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
#include <utility>
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

MovingExcavator machine_with(double control_period_s) {
    Parameters parameters = Parameters::excavator();
    parameters.set("sensors.period", control_period_s);
    return moving_excavator(parameters);
}

/// Returns the inlet area of the stick that the controller asks for in each state.
std::vector<double> commanded_inlets_in2(const MovingExcavator& machine, const DigJob& job,
                                         const std::vector<MovingState>& states) {
    TipReference reference(job, machine.joystick_lag_s);
    std::vector<double> inlets_in2;
    for (const MovingState& state : states) {
        PerLink<TrackedLink> now;
        for (std::size_t i = 0; i < now.size(); ++i)
            now[i] = {state.links[i].inlet_psi, state.links[i].angle_rad, state.links[i].rate_rad_per_s};
        const JointAngles angles = *joint_angles(machine.arm, reference.pose());
        const JointAngles rates = joint_rates(machine.arm, angles, reference.velocity());
        inlets_in2.push_back(
            asked_areas(machine, state.configuration, now, angles, rates)[index_of(Link::stick)].inlet_in2);
        reference.advance(machine.control_period_s);
    }
    return inlets_in2;
}

/// Returns the areas of a valve at the controller's times. The valve starts from 0 and approaches each command, one
/// dead time after the command, like exp(-a_0 t).
std::vector<double> delayed_inlets_in2(const MovingExcavator& machine, const std::vector<double>& commanded_in2) {
    const double period_s = machine.control_period_s;
    const auto whole = static_cast<std::size_t>(machine.dead_time_s / period_s + 1e-9);
    const double part_s = machine.dead_time_s - static_cast<double>(whole) * period_s;
    const double lag = machine.links[index_of(Link::stick)].spool_lag_per_s;
    auto given = [&](std::size_t late, std::size_t s) { return s < late ? 0 : commanded_in2[s - late]; };
    std::vector<double> areas_in2{0};
    for (std::size_t s = 0; s + 1 < commanded_in2.size(); ++s) {
        const double before = given(whole + 1, s), now = given(whole, s);
        const double middle = before + (areas_in2.back() - before) * std::exp(-lag * part_s);
        areas_in2.push_back(now + (middle - now) * std::exp(-lag * (period_s - part_s)));
    }
    return areas_in2;
}

/// The greatest differences between two motions, and the share of the time in which the configurations are equal.
struct Apart {
    double tip_in = 0, angle_rad = 0, same_configuration = 0;
};

/// Compares each state of `usual` with the state of `other` at the same time; `other` has `times` as many periods.
Apart apart_from(const std::vector<MovingState>& usual, const std::vector<MovingState>& other, std::size_t times) {
    REQUIRE(other.size() == times * (usual.size() - 1) + 1);
    Apart apart;
    for (std::size_t s = 0; s < usual.size(); ++s) {
        const JointAngles a = angles_of(usual[s]), b = angles_of(other[times * s]);
        const TipPose from = tip_pose(arm, a), to = tip_pose(arm, b);
        apart.tip_in = std::max(apart.tip_in, std::hypot(from.reach_in - to.reach_in, from.height_in - to.height_in));
        for (std::size_t i = 0; i < a.size(); ++i)
            apart.angle_rad = std::max(apart.angle_rad, std::abs(a[i] - b[i]));
        apart.same_configuration += usual[s].configuration == other[times * s].configuration;
    }
    apart.same_configuration /= static_cast<double>(usual.size());
    return apart;
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

TEST_CASE("each command reaches the pilot valves after their dead time; they approach it like exp(-a_0 t)") {
    for (const auto& [period_s, dead_s] :
         {std::pair{0.02, 0.01}, {0.005, 0.01}, {0.001, 0.01}, {0.02, 0.03}, {0.01, 0.}}) {
        CAPTURE(period_s);
        CAPTURE(dead_s);
        MovingExcavator machine = machine_with(period_s);
        machine.dead_time_s = dead_s;
        const std::vector<MovingState> states = motion(machine, cycle());
        const std::vector<double> expected =
            delayed_inlets_in2(machine, commanded_inlets_in2(machine, cycle(), states));
        double worst = 0, largest = 0;
        for (std::size_t s = 0; s < states.size(); ++s) {
            const double inlet_in2 = states[s].links[index_of(Link::stick)].areas.inlet_in2;
            worst = std::max(worst, std::abs(expected[s] - inlet_in2));
            largest = std::max(largest, inlet_in2);
        }
        CHECK(largest > 0.05);
        CHECK(worst < 1e-9);
    }
}

TEST_CASE("a controller with a shorter period than the dead time digs along the same trajectory") {
    const std::vector<MovingState> usual = motion(machine_with(0.02), cycle());
    for (const int times : {2, 4, 20}) {
        CAPTURE(times);
        const Apart apart = apart_from(usual, motion(machine_with(0.02 / times), cycle()), times);
        CHECK(apart.tip_in < 1);
        CHECK(apart.angle_rad < 1 * rad);
        CHECK(apart.same_configuration > 0.98);
    }
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
