#include "hydraulics/plant/excavator_motion.hpp"

#include "hydraulics/plant/event_step.hpp"
#include "hydraulics/plant/excavator_dynamics.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace placedpar::hydraulics {

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

std::vector<CheckEvent> simulate_excavator(const ExcavatorScenario& scenario,
                                           const std::function<void(ExcavatorState&&)>& show) {
    require_valid(scenario);
    ExcavatorDynamics dynamics(scenario);
    EventStepper stepper(dynamics, dynamics.at_rest(), 0);
    std::vector<CheckEvent> checks;
    auto note = [&](double time_s, const Mode& before, const Mode& behind) {
        for (std::size_t link = 0; link < before.size(); ++link)
            if (before[link].inlet_open != behind[link].inlet_open)
                checks.push_back({time_s, scenario.links[link].link, behind[link].inlet_open});
    };
    auto steps = static_cast<std::size_t>(std::lround(scenario.duration_s / scenario.integration_step_s));
    for (std::size_t i = 0;; ++i) {
        show(state_at(dynamics, stepper.state(), stepper.time_s()));
        if (i == steps)
            return checks;
        stepper.advance_to(static_cast<double>(i + 1) * scenario.integration_step_s, note);
    }
}

ExcavatorMotion simulate_excavator(const ExcavatorScenario& scenario) {
    ExcavatorMotion motion;
    motion.checks =
        simulate_excavator(scenario, [&](ExcavatorState&& state) { motion.states.push_back(std::move(state)); });
    return motion;
}

} // namespace placedpar::hydraulics
