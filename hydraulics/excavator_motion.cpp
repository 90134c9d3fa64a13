#include "hydraulics/excavator_motion.hpp"

#include "hydraulics/event_step.hpp"
#include "hydraulics/excavator_dynamics.hpp"

#include <cmath>
#include <cstddef>

namespace placedpar {

namespace {

using Mode = ExcavatorDynamics::Mode;

ExcavatorState state_at(const ExcavatorDynamics& dynamics, const ExcavatorDynamics::State& state, double time_s) {
    std::vector<JunctionFlow> flows = dynamics.flows(state, time_s);
    ExcavatorState now{time_s, {}};
    for (std::size_t link = 0; link < flows.size(); ++link) {
        const double* part = state.data() + link * ExcavatorDynamics::components;
        now.links.push_back({part[ExcavatorDynamics::inlet_psi], part[ExcavatorDynamics::outlet_psi],
                             part[ExcavatorDynamics::piston_in], part[ExcavatorDynamics::velocity_in_per_s],
                             part[ExcavatorDynamics::spool_in], dynamics.areas(state, link, time_s), flows[link]});
    }
    return now;
}

} // namespace

ExcavatorMotion simulate_excavator(const ExcavatorScenario& scenario) {
    require_valid(scenario);
    ExcavatorDynamics dynamics(scenario);
    EventStepper stepper(dynamics, dynamics.at_rest(), 0);
    ExcavatorMotion motion;
    auto note = [&](double time_s, const Mode& before, const Mode& behind) {
        for (std::size_t link = 0; link < before.size(); ++link)
            if (before[link].inlet_open != behind[link].inlet_open)
                motion.checks.push_back({time_s, scenario.links[link].link, behind[link].inlet_open});
    };
    auto steps = static_cast<std::size_t>(std::lround(scenario.duration_s / scenario.integration_step_s));
    motion.states.reserve(steps + 1);
    for (std::size_t i = 0;; ++i) {
        motion.states.push_back(state_at(dynamics, stepper.state(), stepper.time_s()));
        if (i == steps)
            return motion;
        stepper.advance_to(static_cast<double>(i + 1) * scenario.integration_step_s, note);
    }
}

} // namespace placedpar
