#include "hydraulics/plant/measured_excavator.hpp"

#include "hydraulics/plant/event_step.hpp"
#include "hydraulics/plant/measured_dynamics.hpp"

#include <cmath>
#include <cstddef>
#include <string>

namespace placedpar::hydraulics {

namespace {

Hose hose_of(const Parameters& parameters, const std::string& side) {
    return {parameters["hose." + side + "_inertance"], parameters["hose." + side + "_resistance"],
            parameters["hose." + side + "_valve_share"]};
}

StickFriction friction_of(const Parameters& parameters) {
    double coulomb_lbf = parameters["boom.friction"];
    return {.coulomb_lbf = coulomb_lbf,
            .breakaway_lbf = parameters["stiction.breakaway"] * coulomb_lbf,
            .stribeck_in_per_s = parameters["stiction.stribeck_velocity"],
            .bristle_stiffness_lbf_per_in = parameters["stiction.bristle_stiffness"],
            .bristle_damping_lbf_s_per_in = parameters["stiction.bristle_damping"]};
}

/// Both the sensor and A.1 read too high by the offset: a voltage gives that much less spool than A.1 says.
DriftedVoltageSpool voltage_spool_of(const Parameters& parameters) {
    return {{parameters["fault.servo_bias"], parameters["fault.servo_drift"]}, {-parameters["fault.spool_offset"], 0}};
}

} // namespace

MeasuredExcavator measured_excavator(const Parameters& parameters) {
    return {.flow = flow_constants(parameters),
            .boom = single_boom_mechanics(parameters),
            .ripple = {parameters["pump.ripple"], parameters["pump.pistons"] * parameters["pump.shaft"]},
            .inlet_hose = hose_of(parameters, "inlet"),
            .outlet_hose = hose_of(parameters, "outlet"),
            .friction = friction_of(parameters),
            .oil = air_oil_mixture(parameters["fault.air"], 1, parameters),
            .oil_volume_in3 = parameters["oil.inlet_volume"],
            .drain_laminar_psi = parameters["valve.drain_laminar"],
            .leak = {parameters["fault.leak"], parameters["fault.leak_start"]},
            .voltage_spool = voltage_spool_of(parameters),
            .dead_time_s = parameters["valve.dead_time"],
            .command = servo_command(parameters),
            .sampling_period_s = parameters["sensors.period"],
            .servo_converter = {parameters["sensors.servo_range"], bits_of(parameters, "sensors.servo_bits")},
            .duration_s = parameters["excavator.duration"],
            .integration_step_s = parameters["excavator.integration_step"]};
}

double held_volts(const MeasuredExcavator& excavator, double time_s) {
    // A sampling instant belongs to the period that it begins, even if rounding puts it a bit early.
    double sample = std::floor(time_s / excavator.sampling_period_s + 1e-6);
    const Converter& converter = excavator.servo_converter;
    return converter.limited(volts_at(excavator.command, sample * excavator.sampling_period_s), -converter.range / 2);
}

std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator) {
    require_valid(excavator);
    MeasuredDynamics dynamics(excavator);
    double step_s = excavator.integration_step_s;
    auto steps = static_cast<std::size_t>(std::lround(excavator.duration_s / step_s));
    std::vector<MeasuredState> motion;
    motion.reserve(steps + 1);
    EventStepper stepper(dynamics, dynamics.at_rest(), 0);
    for (std::size_t i = 0;; ++i) {
        double time_s = static_cast<double>(i) * step_s;
        motion.push_back(dynamics.describe(stepper.state(), time_s));
        if (i == steps)
            return motion;
        // Constant within a step: a command that begins does so between two.
        dynamics.hold(time_s + step_s / 2);
        stepper.system_changed();
        stepper.advance_to(static_cast<double>(i + 1) * step_s, [](auto&&...) {});
    }
}

} // namespace placedpar::hydraulics
