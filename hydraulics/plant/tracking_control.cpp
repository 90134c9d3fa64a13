#include "hydraulics/plant/tracking_control.hpp"

#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/plant/feedforward.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

/// The largest share of a junction's flow that a link may ask for. The rest flows through the bypass. A bypass that
/// stays open keeps the flow controllable.
constexpr double most_of_a_junction = 0.98;

/// Returns the flow into the link that the controller asks for: feedforward of the rate, with P-D feedback.
double asked_flow(const MovingExcavator& machine, Link link, const TrackedLink& now, double angle_rad,
                  double rate_rad_per_s) {
    const double rate = rate_rad_per_s + machine.gains.proportional_per_s * (angle_rad - now.angle_rad) +
                        machine.gains.derivative * (rate_rad_per_s - now.rate_rad_per_s);
    const LinkMechanics& mechanics = machine.links[index_of(link)];
    return piston_in3_per_rad(mechanics.inlet_area_in2, mechanics.moment_arm_in) * rate;
}

/// Limits each flow to the flow that reaches the junction, and each pressure so that no junction exceeds the relief
/// pressure.
void limit(const Circuit& circuit, std::vector<FlowTarget>& targets, const MovingExcavator& machine) {
    const FlowConstants& flow = machine.valve.flow;
    const double drops_psi = all_links.size() * (machine.gains.inlet_drop_psi + machine.gains.bypass_drop_psi);
    std::vector<double> comes(circuit.size());
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        targets[j].link_psi = std::min(targets[j].link_psi, flow.relief_psi - drops_psi);
        comes[j] += circuit[j].pumps * flow.pump_in3_per_s;
        targets[j].inlet_in3_per_s = std::min(targets[j].inlet_in3_per_s, most_of_a_junction * comes[j]);
        if (circuit[j].through == Through::junction)
            comes[circuit[j].next] += comes[j] - targets[j].inlet_in3_per_s;
    }
}

/// Returns the configuration for which the controller computes the areas. If the first link of a branch asks for the
/// whole flow of its pump, its bypass may be shut. Otherwise bypass and check valve must stay open, so that the link's
/// flow can be controlled.
Configuration steered(Configuration configuration, const PerLink<double>& asked_in3_per_s, const FlowConstants& flow) {
    auto asks_all = [&](Link link) {
        return asked_in3_per_s[index_of(link)] >= most_of_a_junction * flow.pump_in3_per_s;
    };
    switch (configuration) {
    case Configuration::a: break;
    case Configuration::b:
    case Configuration::d: return asks_all(Link::bucket) ? Configuration::b : Configuration::d;
    case Configuration::c:
    case Configuration::e: return asks_all(Link::swing) ? Configuration::c : Configuration::e;
    }
    return configuration;
}

} // namespace

PerLink<OrificeAreas> asked_areas(const MovingExcavator& machine, Configuration configuration,
                                  const PerLink<TrackedLink>& now, const JointAngles& angles,
                                  const JointAngles& rates) {
    PerLink<OrificeAreas> areas;
    PerLink<double> asked;
    LinkSet pumped;
    for (Link link : all_links) {
        const std::size_t i = index_of(link);
        asked[i] = asked_flow(machine, link, now[i], angles[i], rates[i]);
        areas[i] = {0, machine.bypass_rest_in2, 0};
        const double drop = now[i].inlet_psi - machine.valve.flow.tank_psi;
        if (asked[i] > machine.gains.least_flow_in3_per_s)
            pumped.insert(link);
        else if (asked[i] < -machine.gains.least_flow_in3_per_s && drop > machine.valve.laminar_psi)
            areas[i].outlet_in2 = -asked[i] / machine.valve.flow.conductance(std::sqrt(drop));
    }
    const Configuration steer = steered(configuration, asked, machine.valve.flow);
    for (LinkSet group : coupled_groups(steer)) {
        if ((group & pumped).empty())
            continue;
        const Circuit circuit = circuit_of(steer, group & pumped);
        std::vector<FlowTarget> targets;
        for (const Junction& junction : circuit)
            targets.push_back({now[index_of(junction.link)].inlet_psi, asked[index_of(junction.link)]});
        limit(circuit, targets, machine);
        const auto openings = openings_for(circuit, targets, machine.valve.flow, machine.gains.inlet_drop_psi,
                                           machine.gains.bypass_drop_psi);
        for (std::size_t j = 0; j < circuit.size(); ++j)
            areas[index_of(circuit[j].link)] = {openings[j].inlet_in2, openings[j].bypass_in2, 0};
    }
    return areas;
}

} // namespace placedpar::hydraulics
