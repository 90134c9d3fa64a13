#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/plant/measured_excavator.hpp"
#include "hydraulics/plant/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace placedpar::hydraulics {

namespace {

constexpr Requirement excavator_needs{"measured machine"};

void require_valid_hose(const Hose& hose, std::string_view side) {
    excavator_needs.positive(fmt::format("the {} hose's inertance", side), hose.inertance_psi_s2_per_in3);
    excavator_needs.not_negative(fmt::format("the {} hose's resistance", side), hose.resistance_psi_s_per_in3);
    excavator_needs.share(fmt::format("the valve's share of the {} compliance", side), hose.valve_share);
}

void require_valid_boom(const LinkMechanics& boom) {
    excavator_needs.positive("the inlet area", boom.inlet_area_in2);
    excavator_needs.positive("the outlet area", boom.outlet_area_in2);
    excavator_needs.positive("the moment arm", boom.moment_arm_in);
    excavator_needs.positive("the mass", boom.mass_lbf_s2_per_in);
    excavator_needs.not_negative("the damping", boom.damping_lbf_s_per_in);
    excavator_needs.finite("gravity", boom.load_lbf);
    excavator_needs.positive("the inlet compliance", boom.inlet_compliance_in3_per_psi);
    excavator_needs.positive("the outlet compliance", boom.outlet_compliance_in3_per_psi);
    excavator_needs.positive("the spool's lag", boom.spool_lag_per_s);
}

void require_valid_friction(const StickFriction& friction) {
    excavator_needs.not_negative("friction", friction.coulomb_lbf);
    if (!(friction.breakaway_lbf >= friction.coulomb_lbf && std::isfinite(friction.breakaway_lbf)))
        excavator_needs.refuse("the break-away force", friction.breakaway_lbf,
                               fmt::format("at least the friction of {} lbf", friction.coulomb_lbf));
    excavator_needs.positive("the Stribeck velocity", friction.stribeck_in_per_s);
    excavator_needs.positive("the bristles' stiffness", friction.bristle_stiffness_lbf_per_in);
    excavator_needs.not_negative("the bristles' damping", friction.bristle_damping_lbf_s_per_in);
}

void require_valid_command(const MeasuredExcavator& excavator) {
    for (double volts :
         {excavator.command.at_rest_volts, excavator.command.desired_volts, excavator.command.second_volts,
          excavator.voltage_spool.volts.at_start, excavator.voltage_spool.volts.rate_per_s})
        excavator_needs.finite("a servo voltage", volts);
    excavator_needs.finite("the spool's offset", excavator.voltage_spool.spool_in.at_start);
    excavator_needs.not_negative("the servo's ramp", excavator.command.ramp_s);
    excavator_needs.finite("the time of the step", excavator.command.step_time_s);
    excavator_needs.not_negative("the dead time", excavator.dead_time_s);
    excavator_needs.positive("the sampling period", excavator.sampling_period_s);
    excavator_needs.positive("the servo's range", excavator.servo_converter.range);
    if (excavator.servo_converter.bits < 0 || excavator.servo_converter.bits > 32)
        excavator_needs.refuse("the servo's bits", excavator.servo_converter.bits, "0 to 32");
}

/// Returns the greatest decay rate of the drain side's pressure, per second. The rate is greatest at a pressure drop of
/// 0 and the greatest travel of the spool. The slope of the flow is then k a / sqrt(laminar).
double drain_rate_per_s(const MeasuredExcavator& excavator) {
    double spool_in = 0;
    for (double time_s : {0.0, excavator.duration_s})
        for (double volts :
             {excavator.command.at_rest_volts, excavator.command.desired_volts, excavator.command.second_volts})
            spool_in = std::max(spool_in, excavator.voltage_spool.desired_spool_in(volts, time_s));
    double slope =
        excavator.flow.conductance(boom_orifices(spool_in).outlet_in2) / std::sqrt(excavator.drain_laminar_psi);
    return slope / ends_of(excavator.outlet_hose, excavator.boom.outlet_compliance_in3_per_psi).valve_in3_per_psi;
}

/// Throws UnfitScenario if the integration step is too long. The method is stable if the step times each decay rate,
/// and the step times the frequency of each oscillation, is at most about 2.8. An accurate result for oscillations
/// needs an even shorter step.
void require_short_step(const MeasuredExcavator& excavator) {
    const LinkMechanics& boom = excavator.boom;
    auto resolve = [&](std::string_view what, double rate_per_s, double most) {
        if (!(rate_per_s * excavator.integration_step_s <= most))
            excavator_needs.refuse("the integration step", excavator.integration_step_s,
                                   fmt::format("at most {:.3g} s for {}", most / rate_per_s, what));
    };
    constexpr double traced = 0.5, stable = 2.5;
    resolve("the inlet hose's oscillation",
            natural_rad_per_s(excavator.inlet_hose, ends_of(excavator.inlet_hose, boom.inlet_compliance_in3_per_psi)),
            traced);
    resolve(
        "the outlet hose's oscillation",
        natural_rad_per_s(excavator.outlet_hose, ends_of(excavator.outlet_hose, boom.outlet_compliance_in3_per_psi)),
        traced);
    resolve("the pump's ripple", 2 * std::numbers::pi * excavator.ripple.frequency_per_s, traced);
    resolve("the bristles on the mass",
            std::sqrt(excavator.friction.bristle_stiffness_lbf_per_in / boom.mass_lbf_s2_per_in), traced);
    resolve("the bristles' damping",
            (excavator.friction.bristle_damping_lbf_s_per_in + boom.damping_lbf_s_per_in) / boom.mass_lbf_s2_per_in,
            stable);
    if (excavator.friction.coulomb_lbf > 0) // the fastest sliding that the pump can cause
        resolve("the bristles in sliding",
                excavator.friction.bristle_stiffness_lbf_per_in * excavator.flow.pump_in3_per_s / boom.inlet_area_in2 /
                    excavator.friction.coulomb_lbf,
                stable);
    resolve("the drain", drain_rate_per_s(excavator), stable);
    resolve("the spool", boom.spool_lag_per_s, traced);
}

} // namespace

void require_valid(const MeasuredExcavator& excavator) {
    excavator_needs.positive("the integration step", excavator.integration_step_s);
    excavator_needs.positive("the duration", excavator.duration_s);
    excavator_needs.positive("the orifice constant", excavator.flow.orifice_in3_per_s_in2_sqrt_psi);
    excavator_needs.positive("the pump flow", excavator.flow.pump_in3_per_s);
    excavator_needs.finite("the tank pressure", excavator.flow.tank_psi);
    excavator_needs.positive("the relief pressure", excavator.flow.relief_psi);
    excavator_needs.not_negative("the pump's ripple", excavator.ripple.amplitude);
    if (excavator.ripple.amplitude >= 1)
        excavator_needs.refuse("the pump's ripple", excavator.ripple.amplitude, "below 1");
    excavator_needs.not_negative("the ripple's frequency", excavator.ripple.frequency_per_s);
    require_valid_boom(excavator.boom);
    require_valid_hose(excavator.inlet_hose, "inlet");
    require_valid_hose(excavator.outlet_hose, "outlet");
    require_valid_friction(excavator.friction);
    if (!(excavator.oil.air_fraction >= 0 && excavator.oil.air_fraction < 1))
        excavator_needs.refuse("the air fraction", excavator.oil.air_fraction, "0 or above and below 1");
    excavator_needs.not_negative("the oil's volume", excavator.oil_volume_in3);
    excavator_needs.positive("the laminar drop", excavator.drain_laminar_psi);
    excavator_needs.not_negative("the leak", excavator.leak.in3_per_s_psi);
    excavator_needs.finite("the leak's start", excavator.leak.start_s);
    require_valid_command(excavator);
    require_short_step(excavator);
    excavator_needs.kept_whole(excavator.duration_s, excavator.integration_step_s);
}

} // namespace placedpar::hydraulics
