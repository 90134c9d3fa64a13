#include "hydraulics/plant/measured_excavator.hpp"

#include <cmath>
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

/// With a spool offset, the position from the sensor and the position from equation A.1 are both too high. A voltage
/// therefore moves the spool less far than A.1 states.
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
    // A sampling instant belongs to the period that begins at this instant, even if rounding puts the instant slightly
    // early.
    double sample = std::floor(time_s / excavator.sampling_period_s + 1e-6);
    const Converter& converter = excavator.servo_converter;
    return converter.limited(volts_at(excavator.command, sample * excavator.sampling_period_s), -converter.range / 2);
}

} // namespace placedpar::hydraulics
