#include "hydraulics/boom_motion.hpp"

#include "hydraulics/boom_orifices.hpp"
#include "hydraulics/flow_split.hpp"
#include "hydraulics/leakage.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace placedpar {

namespace {

using State = std::array<double, 5>;
enum Component : std::size_t { inlet_psi, outlet_psi, piston_in, velocity_in_per_s, spool_in };

void require_positive(std::string_view name, double value) {
    if (!(value > 0 && std::isfinite(value)))
        throw std::invalid_argument(fmt::format("boom scenario: {} is {}, expected above 0", name, value));
}

void require_valid(const BoomScenario& scenario) {
    require_positive("the integration step", scenario.integration_step_s);
    require_positive("the duration", scenario.duration_s);
    constexpr double most_steps = 2e6; // the motion is kept whole
    if (scenario.duration_s > most_steps * scenario.integration_step_s)
        throw std::invalid_argument(fmt::format("boom scenario: the duration is {}, expected at most {:g} steps",
                                                scenario.duration_s, most_steps));
    if (!(scenario.ramp_s >= 0))
        throw std::invalid_argument(fmt::format("boom scenario: the ramp is {}, expected 0 or above", scenario.ramp_s));
    require_positive("the pump flow", scenario.flow.pump_in3_per_s);
    require_positive("the mass", scenario.machine.mass_lbf_s2_per_in);
    require_positive("the inlet area", scenario.machine.inlet_area_in2);
    require_positive("the inlet compliance", scenario.machine.inlet_compliance_in3_per_psi);
    require_positive("the outlet compliance", scenario.machine.outlet_compliance_in3_per_psi);
}

/// Flow out of the drain side (3.4); below tank pressure it is fed from the tank.
double drain_in3_per_s(double outlet_in2, double psi, const FlowConstants& flow) {
    double drop = psi - flow.tank_psi;
    return std::copysign(flow.orifice_in3_per_s_in2_sqrt_psi * outlet_in2 * std::sqrt(std::abs(drop)), drop);
}

double piston_force_lbf(const State& state, const BoomMachine& machine) {
    double velocity = state[velocity_in_per_s];
    double friction = machine.friction_lbf * std::tanh(velocity / machine.friction_velocity_in_per_s) +
                      machine.damping_lbf_s_per_in * velocity;
    return machine.inlet_area_in2 * state[inlet_psi] - machine.outlet_area_in2 * state[outlet_psi] -
           machine.gravity_lbf - friction;
}

/// What holds within a step.
struct Held {
    double desired_spool_in;
    double leak_in3_per_s_psi;
};

Held held_at(const BoomScenario& scenario, double time_s) {
    double leak = time_s > scenario.leak_start_s ? scenario.leak_in3_per_s_psi : 0;
    if (time_s <= scenario.step_time_s)
        return {scenario.spool_at_rest_in, leak};
    if (time_s >= scenario.step_time_s + scenario.ramp_s)
        return {scenario.spool_desired_in, leak};
    double gone = (time_s - scenario.step_time_s) / scenario.ramp_s;
    return {scenario.spool_at_rest_in + gone * (scenario.spool_desired_in - scenario.spool_at_rest_in), leak};
}

State derivative(const State& state, const BoomScenario& scenario, const Held& held) {
    const BoomMachine& machine = scenario.machine;
    OrificeAreas areas = boom_orifices(state[spool_in]);
    FlowSplit flows = split_flow(areas.inlet_in2, areas.bypass_in2, state[inlet_psi], scenario.flow);
    double drain = drain_in3_per_s(areas.outlet_in2, state[outlet_psi], scenario.flow);
    double velocity = state[velocity_in_per_s];
    double leak = leakage_in3_per_s(held.leak_in3_per_s_psi, state[inlet_psi], state[outlet_psi]);
    State rate{};
    rate[inlet_psi] =
        (flows.inlet_in3_per_s - machine.inlet_area_in2 * velocity - leak) / machine.inlet_compliance_in3_per_psi;
    rate[outlet_psi] = (machine.outlet_area_in2 * velocity + leak - drain) / machine.outlet_compliance_in3_per_psi;
    rate[piston_in] = velocity;
    rate[velocity_in_per_s] = piston_force_lbf(state, machine) / machine.mass_lbf_s2_per_in;
    rate[spool_in] = machine.spool_lag_per_s * (held.desired_spool_in - state[spool_in]);
    return rate;
}

State state_at_rest(const BoomScenario& scenario) {
    const BoomMachine& machine = scenario.machine;
    State state{};
    state[outlet_psi] = scenario.flow.tank_psi;
    state[inlet_psi] =
        (machine.gravity_lbf + machine.outlet_area_in2 * scenario.flow.tank_psi) / machine.inlet_area_in2;
    state[spool_in] = scenario.spool_at_rest_in;
    return state;
}

} // namespace

std::vector<BoomState> simulate_boom(const BoomScenario& scenario) {
    require_valid(scenario);
    boost::numeric::odeint::runge_kutta4<State> stepper;
    double step_s = scenario.integration_step_s;
    auto steps = static_cast<std::size_t>(std::lround(scenario.duration_s / step_s));
    std::vector<BoomState> motion;
    motion.reserve(steps + 1);
    State state = state_at_rest(scenario);
    for (std::size_t i = 0;; ++i) {
        double time_s = static_cast<double>(i) * step_s;
        motion.push_back(
            {time_s, state[inlet_psi], state[outlet_psi], state[piston_in], state[velocity_in_per_s], state[spool_in]});
        if (i == steps)
            return motion;
        Held held = held_at(scenario, time_s + step_s / 2);
        auto system = [&](const State& at, State& rate, double) { rate = derivative(at, scenario, held); };
        stepper.do_step(system, state, time_s, step_s);
    }
}

} // namespace placedpar
