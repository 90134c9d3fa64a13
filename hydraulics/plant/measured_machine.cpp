#include "hydraulics/plant/measured_machine.hpp"

#include "hydraulics/plant/converter.hpp"
#include "hydraulics/plant/event_step.hpp"
#include "hydraulics/plant/measured_dynamics.hpp"

#include <cmath>
#include <cstddef>

namespace placedpar::hydraulics {

namespace {

Hose hose_of(const Parameters& parameters, const std::string& side) {
    return {parameters["hose." + side + "_inertance"], parameters["hose." + side + "_resistance"],
            parameters["hose." + side + "_valve_share"]};
}

/// Both the sensor and A.1 read too high by the offset: a voltage gives that much less spool than A.1 says.
DriftedVoltageSpool voltage_spool_of(const Parameters& parameters) {
    return {{parameters["fault.servo_bias"], parameters["fault.servo_drift"]}, {-parameters["fault.spool_offset"], 0}};
}

} // namespace

MeasuredMachine::MeasuredMachine(const Parameters& p)
    : flow(flow_constants(p)), boom(p), ripple{p["pump.ripple"], p["pump.pistons"] * p["pump.shaft"]},
      inlet_hose(hose_of(p, "inlet")),
      outlet_hose(hose_of(p, "outlet")), friction{boom.friction_lbf, p["stiction.breakaway"] * boom.friction_lbf,
                                                  p["stiction.stribeck_velocity"], p["stiction.bristle_stiffness"],
                                                  p["stiction.bristle_damping"]},
      oil{p["fault.air"], 1, p["oil.bulk_modulus"], p["oil.atmospheric_pressure"]},
      oil_volume_in3(p["oil.inlet_volume"]), drain_laminar_psi(p["valve.drain_laminar"]),
      leak_in3_per_s_psi(p["fault.leak"]), leak_start_s(p["fault.leak_start"]), voltage_spool(voltage_spool_of(p)),
      dead_time_s(p["valve.dead_time"]), command(servo_command(p)), sampling_period_s(p["sensors.period"]),
      servo_range_volts(p["sensors.servo_range"]), servo_bits(bits_of(p, "sensors.servo_bits")),
      duration_s(p["excavator.duration"]), integration_step_s(p["excavator.integration_step"]) {}

double held_volts(const MeasuredMachine& machine, double time_s) {
    // A sampling instant belongs to the period that it begins, whatever its last bit.
    double sample = std::floor(time_s / machine.sampling_period_s + 1e-6);
    Converter converter{machine.servo_range_volts, machine.servo_bits};
    return converter.limited(volts_at(machine.command, sample * machine.sampling_period_s),
                             -machine.servo_range_volts / 2);
}

std::vector<MeasuredState> simulate_measured_machine(const MeasuredMachine& machine) {
    require_valid(machine);
    MeasuredDynamics dynamics(machine);
    double step_s = machine.integration_step_s;
    auto steps = static_cast<std::size_t>(std::lround(machine.duration_s / step_s));
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
