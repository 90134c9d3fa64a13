#include "hydraulics/boom_orifices.hpp"
#include "hydraulics/measured_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace placedpar {

namespace {

[[noreturn]] void refuse(std::string_view what, double value, std::string_view expected) {
    throw std::invalid_argument(fmt::format("measured machine: {} is {}, expected {}", what, value, expected));
}

void require_positive(std::string_view what, double value) {
    if (!(value > 0 && std::isfinite(value)))
        refuse(what, value, "above 0");
}

void require_not_negative(std::string_view what, double value) {
    if (!(value >= 0 && std::isfinite(value)))
        refuse(what, value, "0 or above");
}

void require_finite(std::string_view what, double value) {
    if (!std::isfinite(value))
        refuse(what, value, "a finite number");
}

void require_share(std::string_view what, double value) {
    if (!(value > 0 && value < 1))
        refuse(what, value, "above 0 and below 1");
}

void require_valid_hose(const Hose& hose, std::string_view side) {
    require_positive(fmt::format("the {} hose's inertance", side), hose.inertance_psi_s2_per_in3);
    require_not_negative(fmt::format("the {} hose's resistance", side), hose.resistance_psi_s_per_in3);
    require_share(fmt::format("the valve's share of the {} compliance", side), hose.valve_share);
}

void require_valid_boom(const BoomMachine& boom) {
    require_positive("the inlet area", boom.inlet_area_in2);
    require_positive("the outlet area", boom.outlet_area_in2);
    require_positive("the moment arm", boom.moment_arm_in);
    require_positive("the mass", boom.mass_lbf_s2_per_in);
    require_not_negative("the damping", boom.damping_lbf_s_per_in);
    require_finite("gravity", boom.gravity_lbf);
    require_positive("the inlet compliance", boom.inlet_compliance_in3_per_psi);
    require_positive("the outlet compliance", boom.outlet_compliance_in3_per_psi);
    require_positive("the spool's lag", boom.spool_lag_per_s);
}

void require_valid_friction(const StickFriction& friction) {
    require_not_negative("friction", friction.coulomb_lbf);
    if (!(friction.breakaway_lbf >= friction.coulomb_lbf && std::isfinite(friction.breakaway_lbf)))
        refuse("the break-away force", friction.breakaway_lbf,
               fmt::format("at least the friction of {} lbf", friction.coulomb_lbf));
    require_positive("the Stribeck velocity", friction.stribeck_in_per_s);
    require_positive("the bristles' stiffness", friction.bristle_stiffness_lbf_per_in);
    require_not_negative("the bristles' damping", friction.bristle_damping_lbf_s_per_in);
}

void require_valid_command(const MeasuredMachine& machine) {
    for (double volts : {machine.command.at_rest_volts, machine.command.desired_volts, machine.command.second_volts,
                         machine.voltage_spool.volts.at_start, machine.voltage_spool.volts.rate_per_s})
        require_finite("a servo voltage", volts);
    require_finite("the spool's offset", machine.voltage_spool.spool_in.at_start);
    require_not_negative("the servo's ramp", machine.command.ramp_s);
    require_finite("the time of the step", machine.command.step_time_s);
    require_not_negative("the dead time", machine.dead_time_s);
    require_positive("the sampling period", machine.sampling_period_s);
    require_positive("the servo's range", machine.servo_range_volts);
    if (machine.servo_bits < 0 || machine.servo_bits > 32)
        refuse("the servo's bits", machine.servo_bits, "0 to 32");
}

/// The drain with the spool at its furthest has the steepest slope at a drop of 0: k a / sqrt(laminar).
double drain_rate_per_s(const MeasuredMachine& machine) {
    double spool_in = 0;
    for (double time_s : {0.0, machine.duration_s})
        for (double volts :
             {machine.command.at_rest_volts, machine.command.desired_volts, machine.command.second_volts})
            spool_in = std::max(spool_in, machine.voltage_spool.desired_spool_in(volts, time_s));
    double slope = machine.flow.orifice_in3_per_s_in2_sqrt_psi * boom_orifices(spool_in).outlet_in2 /
                   std::sqrt(machine.drain_laminar_psi);
    return slope / ends_of(machine.outlet_hose, machine.boom.outlet_compliance_in3_per_psi).valve_in3_per_psi;
}

/// The method is stable up to 2.78 of a decay's rate times the step, and of an oscillation's; the latter should be
/// traced, not only survive.
void require_short_step(const MeasuredMachine& machine) {
    const BoomMachine& boom = machine.boom;
    auto require = [&](std::string_view what, double rate_per_s, double most) {
        if (!(rate_per_s * machine.integration_step_s <= most))
            refuse("the integration step", machine.integration_step_s,
                   fmt::format("at most {:.3g} s for {}", most / rate_per_s, what));
    };
    constexpr double traced = 0.5, stable = 2.5;
    require("the inlet hose's oscillation",
            natural_rad_per_s(machine.inlet_hose, ends_of(machine.inlet_hose, boom.inlet_compliance_in3_per_psi)),
            traced);
    require("the outlet hose's oscillation",
            natural_rad_per_s(machine.outlet_hose, ends_of(machine.outlet_hose, boom.outlet_compliance_in3_per_psi)),
            traced);
    require("the pump's ripple", 2 * std::numbers::pi * machine.ripple.frequency_per_s, traced);
    require("the bristles on the mass",
            std::sqrt(machine.friction.bristle_stiffness_lbf_per_in / boom.mass_lbf_s2_per_in), traced);
    require("the bristles' damping",
            (machine.friction.bristle_damping_lbf_s_per_in + boom.damping_lbf_s_per_in) / boom.mass_lbf_s2_per_in,
            stable);
    if (machine.friction.coulomb_lbf > 0) // sliding as fast as the pump can make it
        require("the bristles in sliding",
                machine.friction.bristle_stiffness_lbf_per_in * machine.flow.pump_in3_per_s / boom.inlet_area_in2 /
                    machine.friction.coulomb_lbf,
                stable);
    require("the drain", drain_rate_per_s(machine), stable);
    require("the spool", boom.spool_lag_per_s, traced);
}

} // namespace

void require_valid(const MeasuredMachine& machine) {
    require_positive("the integration step", machine.integration_step_s);
    require_positive("the duration", machine.duration_s);
    require_positive("the orifice constant", machine.flow.orifice_in3_per_s_in2_sqrt_psi);
    require_positive("the pump flow", machine.flow.pump_in3_per_s);
    require_finite("the tank pressure", machine.flow.tank_psi);
    require_positive("the relief pressure", machine.flow.relief_psi);
    require_not_negative("the pump's ripple", machine.ripple.amplitude);
    if (machine.ripple.amplitude >= 1)
        refuse("the pump's ripple", machine.ripple.amplitude, "below 1");
    require_not_negative("the ripple's frequency", machine.ripple.frequency_per_s);
    require_valid_boom(machine.boom);
    require_valid_hose(machine.inlet_hose, "inlet");
    require_valid_hose(machine.outlet_hose, "outlet");
    require_valid_friction(machine.friction);
    if (!(machine.oil.air_fraction >= 0 && machine.oil.air_fraction < 1))
        refuse("the air fraction", machine.oil.air_fraction, "0 or above and below 1");
    require_not_negative("the oil's volume", machine.oil_volume_in3);
    require_positive("the laminar drop", machine.drain_laminar_psi);
    require_not_negative("the leak", machine.leak_in3_per_s_psi);
    require_finite("the leak's start", machine.leak_start_s);
    require_valid_command(machine);
    require_short_step(machine);
    constexpr double most_steps = 2e6; // the motion is kept whole
    if (machine.duration_s > most_steps * machine.integration_step_s)
        refuse("the duration", machine.duration_s, fmt::format("at most {:g} integration steps", most_steps));
}

} // namespace placedpar
