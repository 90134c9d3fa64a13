#include "hydraulics/plant/boom_control.hpp"

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/circuit/steady_flow.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"
#include "hydraulics/data/units.hpp"

#include <algorithm>
#include <cstddef>

namespace placedpar::hydraulics {

namespace {

/// The desired flow is limited to these shares of the pump's flow. In this range there is a spool position for every
/// pressure below the relief pressure.
constexpr double least_share = 0.01, greatest_share = 0.9;

/// Returns the slope of the line fitted to the last five readings. Returns 0 if there are fewer than five readings.
double last_slope_per_s(const std::vector<double>& readings, double period_s) {
    constexpr std::size_t side = line_fit_points / 2;
    return readings.size() < line_fit_points
               ? 0
               : CentredLineFit(period_s).slope_per_s(readings, readings.size() - 1 - side);
}

double volts_for(double speed_deg_per_s, double inlet_psi, const MeasuredExcavator& excavator) {
    const LinkMechanics& boom = excavator.boom;
    const double flow_in3_per_s =
        piston_in3_per_rad(boom.inlet_area_in2, boom.moment_arm_in) * speed_deg_per_s / deg_per_rad;
    const double pump = excavator.flow.pump_in3_per_s;
    const double limited = std::clamp(flow_in3_per_s, least_share * pump, greatest_share * pump);
    const double psi = std::min(inlet_psi, greatest_share * excavator.flow.relief_psi);
    return servo_volts(boom_spool_for_flow(limited, psi, excavator.flow));
}

} // namespace

BoomControl boom_control(const Parameters& parameters) {
    return {.speed_deg_per_s = parameters["controller.asked_flow"] * deg_per_rad /
                               piston_in3_per_rad(parameters["boom.inlet_area"], parameters["boom.moment_arm"]),
            .step_time_s = parameters["excavator.step_time"],
            .proportional_per_s = parameters["boom_control.proportional_gain"],
            .velocity = parameters["boom_control.velocity_gain"]};
}

ControlledMotion simulate_controlled(const MeasuredExcavator& excavator, const BoomSensors& sensors,
                                     const BoomControl& control, const UniformSource& uniform) {
    ControlledMotion motion;
    Record& record = motion.record;
    record.period_s = sensors.period_s;
    auto volts_at = [&](const MeasuredState& state) {
        read_boom_sensors(state, excavator, sensors, uniform, record);
        const std::vector<double>& angle = record.of(Link::boom, Sensor::angle);
        double volts = excavator.command.at_rest_volts;
        if (state.time_s >= control.step_time_s) {
            const double off_deg = sensors.joint_at_rest_deg + control.desired_deg(state.time_s) - angle.back();
            const double slow_deg_per_s = control.speed_deg_per_s - last_slope_per_s(angle, record.period_s);
            volts = volts_for(control.speed_deg_per_s + control.proportional_per_s * off_deg +
                                  control.velocity * slow_deg_per_s,
                              record.of(Link::boom, Sensor::inlet_pressure).back(), excavator);
        }
        record.of(Link::boom, Sensor::servo).push_back(volts);
        return volts;
    };
    motion.states = simulate_measured_excavator(excavator, volts_at);
    return motion;
}

} // namespace placedpar::hydraulics
