#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/moving_excavator.hpp"
#include "hydraulics/plant/requirement.hpp"

#include <doctest/doctest.h>

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

} // namespace

TEST_CASE("the pose of the joint angles of a pose is the pose, all over the reachable space") {
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

TEST_CASE("joint rates move the tip at its velocity, and torques do the work of the force") {
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

TEST_CASE("half the integration step gives the same motion") {
    MovingExcavator machine = moving_excavator(Parameters::excavator());
    const MovingState coarse = motion(machine, cycle()).back();
    machine.integration_step_s /= 2;
    const MovingState fine = motion(machine, cycle()).back();
    for (std::size_t i = 0; i < fine.links.size(); ++i)
        CHECK(std::abs(coarse.links[i].angle_rad - fine.links[i].angle_rad) < 0.05 * rad);
}

TEST_CASE("a job beyond the arm's reach and soil that lifts a load are refused with the move") {
    const MovingExcavator machine = moving_excavator(Parameters::excavator());
    DigJob job = cycle();
    job.moves[2].velocity.reach_in = 60;
    CHECK_THROWS_WITH_AS(motion(machine, job), "move 3: the arm does not reach the tip's path", UnfitScenario);
    job = cycle();
    job.moves[1].soil_lbf = 50000;
    CHECK_THROWS_AS(motion(machine, job), UnfitScenario);
}
