#include "hydraulics/plant/measured_motion.hpp"

#include "hydraulics/plant/event_step.hpp"
#include "hydraulics/plant/measured_dynamics.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace placedpar::hydraulics {

namespace {

MeasuredState state_at(const MeasuredDynamics& dynamics, const MeasuredDynamics::State& state, double time_s) {
    FlowSplit flows = dynamics.flows(state, time_s);
    return {.time_s = time_s,
            .inlet_psi = state[MeasuredDynamics::inlet_psi],
            .inlet_cylinder_psi = state[MeasuredDynamics::inlet_cylinder_psi],
            .outlet_psi = state[MeasuredDynamics::outlet_psi],
            .outlet_cylinder_psi = state[MeasuredDynamics::outlet_cylinder_psi],
            .piston_in = state[MeasuredDynamics::piston_in],
            .velocity_in_per_s = state[MeasuredDynamics::velocity_in_per_s],
            .spool_in = state[MeasuredDynamics::spool_in],
            .pump_in3_per_s = dynamics.pump_in3_per_s(time_s),
            .inlet_in3_per_s = flows.inlet_in3_per_s,
            .bypass_in3_per_s = flows.bypass_in3_per_s,
            .inlet_hose_in3_per_s = state[MeasuredDynamics::inlet_hose_in3_per_s],
            .leak_in3_per_s = dynamics.leak_in3_per_s(state, time_s)};
}

/// Simulates the excavator. `hold(dynamics, state, step)` sets the voltage of each step.
template <typename Hold>
std::vector<MeasuredState> simulate(const MeasuredExcavator& excavator, Hold hold) {
    require_valid(excavator);
    MeasuredDynamics dynamics(excavator);
    double step_s = excavator.integration_step_s;
    auto steps = static_cast<std::size_t>(std::lround(excavator.duration_s / step_s));
    std::vector<MeasuredState> motion;
    motion.reserve(steps + 1);
    EventStepper stepper(dynamics, dynamics.at_rest(), 0);
    for (std::size_t i = 0;; ++i) {
        motion.push_back(state_at(dynamics, stepper.state(), static_cast<double>(i) * step_s));
        if (i == steps)
            return motion;
        hold(dynamics, motion.back(), i);
        stepper.system_changed();
        stepper.advance_to(static_cast<double>(i + 1) * step_s, [](auto&&...) {});
    }
}

} // namespace

std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator) {
    // The command at the middle of a step applies to the whole step, since commands begin between two steps.
    return simulate(excavator, [&](MeasuredDynamics& dynamics, const MeasuredState& state, std::size_t) {
        dynamics.hold(state.time_s + excavator.integration_step_s / 2);
    });
}

std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator,
                                                       const VoltageControl& control) {
    const std::size_t stride = steps_in(excavator.sampling_period_s, excavator.integration_step_s);
    const Converter& converter = excavator.servo_converter;
    std::vector<double> volts; // voltage of each sampling period
    return simulate(excavator, [&](MeasuredDynamics& dynamics, const MeasuredState& state, std::size_t step) {
        if (step % stride == 0)
            volts.push_back(converter.limited(control(state), -converter.range / 2));
        const double time_s = state.time_s + excavator.integration_step_s / 2;
        const double acted_on_s = std::max(time_s - excavator.dead_time_s, 0.0);
        dynamics.hold(volts[static_cast<std::size_t>(acted_on_s / excavator.sampling_period_s + 1e-6)], time_s);
    });
}

} // namespace placedpar::hydraulics
