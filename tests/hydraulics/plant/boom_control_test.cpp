#include "hydraulics/plant/boom_control.hpp"

#include "hydraulics/plant/record_scenario.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

/// Returns the boom's mean lag behind its reference in the last second, in degrees.
double lag_deg(double leak, double bias_volts, bool closed, std::uint64_t seed) {
    Parameters machine = Parameters::excavator();
    for (Parameter& row : noise_rows(machine, "low"))
        machine.put(std::move(row));
    MeasuredExcavator excavator = measured_excavator(machine);
    const BoomControl control = boom_control(machine);
    excavator.leak = {leak, control.step_time_s};
    excavator.voltage_spool.volts.at_start = bias_volts;
    RandomStream sensors(seed, "sensors");
    const ControlledMotion motion = simulate_controlled(
        excavator, boom_sensors(machine), closed ? control : control.open_loop(), [&] { return sensors.uniform(); });
    double sum = 0, count = 0;
    for (const MeasuredState& state : motion.states)
        if (state.time_s >= 3) {
            sum += control.desired_deg(state.time_s) - excavator.boom.joint_deg(state.piston_in);
            ++count;
        }
    return sum / count;
}

} // namespace

TEST_CASE("feedback keeps the boom at its reference, and hides most of a leak and of a servo-valve's bias") {
    for (std::uint64_t seed = 501; seed <= 503; ++seed) {
        CAPTURE(seed);
        const double sound = lag_deg(0, 0, true, seed), open = lag_deg(0, 0, false, seed);
        CHECK(std::abs(sound) < 0.1);
        CHECK(open > 1); // without feedback nothing makes up for the spool's lag
        CHECK(lag_deg(0.004, 0, false, seed) - open > 1.5);
        CHECK(lag_deg(0.004, 0, true, seed) - sound < 0.4);
        CHECK(lag_deg(0.004, 0, true, seed) - sound > 0.1); // there is no integral part, so some of the effect remains
        CHECK(lag_deg(0, -0.04, true, seed) - sound < 0.25 * (lag_deg(0, -0.04, false, seed) - open));
    }
}

TEST_CASE("the record under control has the readings that the control used") {
    const Parameters machine = Parameters::excavator();
    const MeasuredExcavator excavator = measured_excavator(machine);
    RandomStream sensors(7, "sensors");
    const ControlledMotion motion =
        simulate_controlled(excavator, boom_sensors(machine), boom_control(machine), [&] { return sensors.uniform(); });
    const auto& volts = motion.record.of(Link::boom, Sensor::servo);
    REQUIRE(volts.size() == motion.record.size());
    CHECK(motion.record.of(Link::boom, Sensor::angle).size() == volts.size());
    CHECK(volts.front() == excavator.command.at_rest_volts);
    CHECK(volts.back() > 0.3);
    CHECK(volts.back() < 0.4);
}
