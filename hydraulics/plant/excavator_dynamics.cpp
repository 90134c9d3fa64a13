#include "hydraulics/plant/excavator_dynamics.hpp"

#include "hydraulics/circuit/leakage.hpp"
#include "hydraulics/circuit/orifice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

using Dynamics = ExcavatorDynamics;

double part(const Dynamics::State& state, std::size_t link, Dynamics::Component component) {
    return state[link * Dynamics::components + component];
}

/// Returns the flow from the drain side (3.4). The flow is negative, that is, oil flows from the tank, if the pressure
/// is below the tank's pressure.
double drain_in3_per_s(double outlet_in2, double psi, const FlowConstants& flow) {
    double drop = psi - flow.tank_psi;
    return std::copysign(orifice_flow(flow.conductance(outlet_in2), std::abs(drop)), drop);
}

bool leaking(const PistonLeak& leak, double time_s) { return leak.in3_per_s_psi > 0 && time_s >= leak.start_s; }

} // namespace

ExcavatorDynamics::ExcavatorDynamics(const ExcavatorScenario& scenario)
    : scenario_(scenario), circuit_(junctions_of(scenario)), junction_of_(scenario.links.size()) {
    for (std::size_t j = 0; j < circuit_.size(); ++j) {
        auto at = std::ranges::find(scenario.links, circuit_[j].link, &ActiveLink::link);
        link_at_.push_back(static_cast<std::size_t>(at - scenario.links.begin()));
        junction_of_[link_at_.back()] = j;
    }
}

ExcavatorDynamics::State ExcavatorDynamics::at_rest() const {
    State state;
    for (const ActiveLink& active : scenario_.links) {
        const LinkMechanics& mechanics = active.mechanics;
        const auto* spool = std::get_if<SpoolOrifices>(&active.valve);
        double outlet = scenario_.flow.tank_psi;
        state.insert(state.end(), {mechanics.steady_inlet_psi(outlet), outlet, 0, 0, spool ? spool->rest_in : 0});
    }
    return state;
}

OrificeAreas ExcavatorDynamics::areas(const State& state, std::size_t link, double time_s) const {
    if (const auto* timed = std::get_if<TimedOrifices>(&scenario_.links[link].valve))
        return areas_at(*timed, time_s);
    return boom_orifices(part(state, link, spool_in));
}

void ExcavatorDynamics::solve_flows(const State& state, double time_s, std::vector<JunctionFlow>& by_junction) const {
    std::array<JunctionOpening, all_links.size()> openings{};
    for (std::size_t j = 0; j < circuit_.size(); ++j) {
        OrificeAreas open = areas(state, link_at_[j], time_s);
        openings[j] = {part(state, link_at_[j], inlet_psi), open.inlet_in2, open.bypass_in2};
    }
    by_junction.resize(circuit_.size());
    solve_junctions(circuit_, std::span(openings).first(circuit_.size()), scenario_.flow, by_junction);
}

std::vector<JunctionFlow> ExcavatorDynamics::flows(const State& state, double time_s) const {
    std::vector<JunctionFlow> by_junction, by_link;
    solve_flows(state, time_s, by_junction);
    for (std::size_t junction : junction_of_)
        by_link.push_back(by_junction[junction]);
    return by_link;
}

LinkMode ExcavatorDynamics::mode_of(const State& state, std::size_t link, double time_s,
                                    const std::vector<JunctionFlow>& by_junction) const {
    const ActiveLink& active = scenario_.links[link];
    const Junction& junction = circuit_[junction_of_[link]];
    const JunctionFlow& flow = by_junction[junction_of_[link]];
    bool onward = junction.through == Through::junction;
    LinkMode mode;
    mode.inlet_open = flow.psi > part(state, link, inlet_psi);
    mode.bypass_open = flow.psi > (onward ? by_junction[junction.next].psi : scenario_.flow.tank_psi);
    mode.relieving = flow.relief_in3_per_s > 0;
    mode.leaking = leaking(active.leak, time_s);
    if (std::holds_alternative<SpoolOrifices>(active.valve))
        mode.spool_branch = boom_orifice_branch(part(state, link, spool_in));
    mode.command = begun_and_ended(active.valve, time_s);
    return mode;
}

void ExcavatorDynamics::link_rate(const State& state, std::size_t link, double time_s, double inlet_in3_per_s,
                                  State& derivative) const {
    const ActiveLink& active = scenario_.links[link];
    const LinkMechanics& mechanics = active.mechanics;
    double inlet = part(state, link, inlet_psi), outlet = part(state, link, outlet_psi);
    double velocity = part(state, link, velocity_in_per_s);
    double leak = leaking(active.leak, time_s) ? leakage_in3_per_s(active.leak.in3_per_s_psi, inlet, outlet) : 0;
    double friction = mechanics.friction_lbf * std::tanh(velocity / mechanics.friction_velocity_in_per_s) +
                      mechanics.damping_lbf_s_per_in * velocity;
    double force =
        mechanics.inlet_area_in2 * inlet - mechanics.outlet_area_in2 * outlet - mechanics.load_lbf - friction;
    double* rate = derivative.data() + link * components;
    rate[inlet_psi] =
        (inlet_in3_per_s - mechanics.inlet_area_in2 * velocity - leak) / mechanics.inlet_compliance_in3_per_psi;
    rate[outlet_psi] = 0;
    if (mechanics.outlet_area_in2 > 0) {
        double drain = drain_in3_per_s(areas(state, link, time_s).outlet_in2, outlet, scenario_.flow);
        rate[outlet_psi] =
            (mechanics.outlet_area_in2 * velocity + leak - drain) / mechanics.outlet_compliance_in3_per_psi;
    }
    rate[piston_in] = velocity;
    rate[velocity_in_per_s] = force / mechanics.mass_lbf_s2_per_in;
    rate[spool_in] = 0;
    if (const auto* valve = std::get_if<SpoolOrifices>(&active.valve))
        rate[spool_in] = mechanics.spool_lag_per_s * (desired_in(*valve, time_s) - part(state, link, spool_in));
}

ExcavatorDynamics::Mode ExcavatorDynamics::rate(const State& state, State& derivative, double time_s) const {
    std::vector<JunctionFlow> by_junction;
    solve_flows(state, time_s, by_junction);
    Mode mode;
    mode.reserve(scenario_.links.size());
    for (std::size_t link = 0; link < scenario_.links.size(); ++link) {
        link_rate(state, link, time_s, by_junction[junction_of_[link]].inlet_in3_per_s, derivative);
        mode.push_back(mode_of(state, link, time_s, by_junction));
    }
    return mode;
}

} // namespace placedpar::hydraulics
