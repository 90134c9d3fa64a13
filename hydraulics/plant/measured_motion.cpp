#include "hydraulics/plant/measured_motion.hpp"

#include "hydraulics/plant/event_step.hpp"
#include "hydraulics/plant/measured_dynamics.hpp"

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

} // namespace

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
        motion.push_back(state_at(dynamics, stepper.state(), time_s));
        if (i == steps)
            return motion;
        // The command is constant within a step: a command begins between two steps.
        dynamics.hold(time_s + step_s / 2);
        stepper.system_changed();
        stepper.advance_to(static_cast<double>(i + 1) * step_s, [](auto&&...) {});
    }
}

} // namespace placedpar::hydraulics
