#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/plant/measured_dynamics.hpp"
#include "hydraulics/plant/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace placedpar::hydraulics {

namespace {

constexpr Requirement machine_needs{"measured machine"};

void require_valid_hose(const Hose& hose, std::string_view side) {
    machine_needs.positive(fmt::format("the {} hose's inertance", side), hose.inertance_psi_s2_per_in3);
    machine_needs.not_negative(fmt::format("the {} hose's resistance", side), hose.resistance_psi_s_per_in3);
    machine_needs.share(fmt::format("the valve's share of the {} compliance", side), hose.valve_share);
}

void require_valid_boom(const BoomMachine& boom) {
    machine_needs.positive("the inlet area", boom.inlet_area_in2);
    machine_needs.positive("the outlet area", boom.outlet_area_in2);
    machine_needs.positive("the moment arm", boom.moment_arm_in);
    machine_needs.positive("the mass", boom.mass_lbf_s2_per_in);
    machine_needs.not_negative("the damping", boom.damping_lbf_s_per_in);
    machine_needs.finite("gravity", boom.gravity_lbf);
    machine_needs.positive("the inlet compliance", boom.inlet_compliance_in3_per_psi);
    machine_needs.positive("the outlet compliance", boom.outlet_compliance_in3_per_psi);
    machine_needs.positive("the spool's lag", boom.spool_lag_per_s);
}

void require_valid_friction(const StickFriction& friction) {
    machine_needs.not_negative("friction", friction.coulomb_lbf);
    if (!(friction.breakaway_lbf >= friction.coulomb_lbf && std::isfinite(friction.breakaway_lbf)))
        machine_needs.refuse("the break-away force", friction.breakaway_lbf,
                             fmt::format("at least the friction of {} lbf", friction.coulomb_lbf));
    machine_needs.positive("the Stribeck velocity", friction.stribeck_in_per_s);
    machine_needs.positive("the bristles' stiffness", friction.bristle_stiffness_lbf_per_in);
    machine_needs.not_negative("the bristles' damping", friction.bristle_damping_lbf_s_per_in);
}

void require_valid_command(const MeasuredMachine& machine) {
    for (double volts : {machine.command.at_rest_volts, machine.command.desired_volts, machine.command.second_volts,
                         machine.voltage_spool.volts.at_start, machine.voltage_spool.volts.rate_per_s})
        machine_needs.finite("a servo voltage", volts);
    machine_needs.finite("the spool's offset", machine.voltage_spool.spool_in.at_start);
    machine_needs.not_negative("the servo's ramp", machine.command.ramp_s);
    machine_needs.finite("the time of the step", machine.command.step_time_s);
    machine_needs.not_negative("the dead time", machine.dead_time_s);
    machine_needs.positive("the sampling period", machine.sampling_period_s);
    machine_needs.positive("the servo's range", machine.servo_range_volts);
    if (machine.servo_bits < 0 || machine.servo_bits > 32)
        machine_needs.refuse("the servo's bits", machine.servo_bits, "0 to 32");
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
    auto resolve = [&](std::string_view what, double rate_per_s, double most) {
        if (!(rate_per_s * machine.integration_step_s <= most))
            machine_needs.refuse("the integration step", machine.integration_step_s,
                                 fmt::format("at most {:.3g} s for {}", most / rate_per_s, what));
    };
    constexpr double traced = 0.5, stable = 2.5;
    resolve("the inlet hose's oscillation",
            natural_rad_per_s(machine.inlet_hose, ends_of(machine.inlet_hose, boom.inlet_compliance_in3_per_psi)),
            traced);
    resolve("the outlet hose's oscillation",
            natural_rad_per_s(machine.outlet_hose, ends_of(machine.outlet_hose, boom.outlet_compliance_in3_per_psi)),
            traced);
    resolve("the pump's ripple", 2 * std::numbers::pi * machine.ripple.frequency_per_s, traced);
    resolve("the bristles on the mass",
            std::sqrt(machine.friction.bristle_stiffness_lbf_per_in / boom.mass_lbf_s2_per_in), traced);
    resolve("the bristles' damping",
            (machine.friction.bristle_damping_lbf_s_per_in + boom.damping_lbf_s_per_in) / boom.mass_lbf_s2_per_in,
            stable);
    if (machine.friction.coulomb_lbf > 0) // sliding as fast as the pump can make it
        resolve("the bristles in sliding",
                machine.friction.bristle_stiffness_lbf_per_in * machine.flow.pump_in3_per_s / boom.inlet_area_in2 /
                    machine.friction.coulomb_lbf,
                stable);
    resolve("the drain", drain_rate_per_s(machine), stable);
    resolve("the spool", boom.spool_lag_per_s, traced);
}

} // namespace

void require_valid(const MeasuredMachine& machine) {
    machine_needs.positive("the integration step", machine.integration_step_s);
    machine_needs.positive("the duration", machine.duration_s);
    machine_needs.positive("the orifice constant", machine.flow.orifice_in3_per_s_in2_sqrt_psi);
    machine_needs.positive("the pump flow", machine.flow.pump_in3_per_s);
    machine_needs.finite("the tank pressure", machine.flow.tank_psi);
    machine_needs.positive("the relief pressure", machine.flow.relief_psi);
    machine_needs.not_negative("the pump's ripple", machine.ripple.amplitude);
    if (machine.ripple.amplitude >= 1)
        machine_needs.refuse("the pump's ripple", machine.ripple.amplitude, "below 1");
    machine_needs.not_negative("the ripple's frequency", machine.ripple.frequency_per_s);
    require_valid_boom(machine.boom);
    require_valid_hose(machine.inlet_hose, "inlet");
    require_valid_hose(machine.outlet_hose, "outlet");
    require_valid_friction(machine.friction);
    if (!(machine.oil.air_fraction >= 0 && machine.oil.air_fraction < 1))
        machine_needs.refuse("the air fraction", machine.oil.air_fraction, "0 or above and below 1");
    machine_needs.not_negative("the oil's volume", machine.oil_volume_in3);
    machine_needs.positive("the laminar drop", machine.drain_laminar_psi);
    machine_needs.not_negative("the leak", machine.leak_in3_per_s_psi);
    machine_needs.finite("the leak's start", machine.leak_start_s);
    require_valid_command(machine);
    require_short_step(machine);
    constexpr double most_steps = 2e6; // the motion is kept whole
    if (machine.duration_s > most_steps * machine.integration_step_s)
        machine_needs.refuse("the duration", machine.duration_s,
                             fmt::format("at most {:g} integration steps", most_steps));
}

} // namespace placedpar::hydraulics
