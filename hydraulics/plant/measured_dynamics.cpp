#include "hydraulics/plant/measured_dynamics.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/leakage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placedpar::hydraulics {

namespace {

/// Below this pressure the oil forms vapour, and the formula for a mixture of oil and air is not valid.
constexpr double least_psia = 1;

/// Returns the compliance at the cylinder's end of the inlet side, where free air gathers and adds to the compliance.
double cylinder_compliance(const MeasuredExcavator& excavator, double without_air, double psi) {
    if (excavator.oil.air_fraction == 0)
        return without_air;
    double psia = std::max(psi + excavator.oil.atmospheric_psia, least_psia);
    return without_air + fluid_compliance_in3_per_psi(excavator.oil_volume_in3, bulk_modulus_psi(excavator.oil, psia)) -
           fluid_compliance_in3_per_psi(excavator.oil_volume_in3, excavator.oil.oil_modulus_psi);
}

} // namespace

double drain_in3_per_s(double outlet_in2, double drop_psi, double laminar_psi, const FlowConstants& flow) {
    double root = std::sqrt(std::sqrt(drop_psi * drop_psi + laminar_psi * laminar_psi));
    return flow.conductance(outlet_in2) * drop_psi / root;
}

MeasuredDynamics::State MeasuredDynamics::at_rest() const {
    double tank = excavator_.flow.tank_psi;
    State state(components);
    state[outlet_psi] = state[outlet_cylinder_psi] = tank;
    state[inlet_psi] = state[inlet_cylinder_psi] = excavator_.boom.steady_inlet_psi(tank);
    state[spool_in] = excavator_.voltage_spool.desired_spool_in(held_volts(excavator_, 0), 0);
    return state;
}

void MeasuredDynamics::hold(double time_s) {
    double acted_on_s = std::max(time_s - excavator_.dead_time_s, 0.0);
    hold(held_volts(excavator_, acted_on_s), time_s);
}

void MeasuredDynamics::hold(double volts, double time_s) {
    desired_spool_in_ = excavator_.voltage_spool.desired_spool_in(volts, time_s);
}

double MeasuredDynamics::pump_in3_per_s(double time_s) const {
    double turn = 2 * std::numbers::pi * excavator_.ripple.frequency_per_s * time_s;
    return excavator_.flow.pump_in3_per_s * (1 + excavator_.ripple.amplitude * std::sin(turn));
}

FlowConstants MeasuredDynamics::flow_at(double time_s) const {
    FlowConstants flow = excavator_.flow;
    flow.pump_in3_per_s = pump_in3_per_s(time_s);
    return flow;
}

double MeasuredDynamics::leak_in3_per_s(const State& state, double time_s) const {
    double leak = time_s >= excavator_.leak.start_s ? excavator_.leak.in3_per_s_psi : 0;
    return leakage_in3_per_s(leak, state[inlet_cylinder_psi], state[outlet_cylinder_psi]);
}

double MeasuredDynamics::acceleration(const State& state) const {
    const LinkMechanics& boom = excavator_.boom;
    double velocity = state[velocity_in_per_s];
    double force = boom.inlet_area_in2 * state[inlet_cylinder_psi] - boom.outlet_area_in2 * state[outlet_cylinder_psi] -
                   boom.load_lbf - boom.damping_lbf_s_per_in * velocity -
                   friction_force_lbf(excavator_.friction, velocity, state[bristle_in]);
    return force / boom.mass_lbf_s2_per_in;
}

FlowSplit MeasuredDynamics::flows(const State& state, double time_s) const {
    OrificeAreas areas = boom_orifices(state[spool_in]);
    return split_flow(areas.inlet_in2, areas.bypass_in2, state[inlet_psi], flow_at(time_s));
}

MeasuredDynamics::Mode MeasuredDynamics::rate(const State& state, State& derivative, double time_s) const {
    const LinkMechanics& boom = excavator_.boom;
    OrificeAreas areas = boom_orifices(state[spool_in]);
    FlowSplit flows = split_flow(areas.inlet_in2, areas.bypass_in2, state[inlet_psi], flow_at(time_s));
    double velocity = state[velocity_in_per_s], leak = leak_in3_per_s(state, time_s);
    double drained = drain_in3_per_s(areas.outlet_in2, state[outlet_psi] - excavator_.flow.tank_psi,
                                     excavator_.drain_laminar_psi, excavator_.flow);
    HoseEnds inlet = ends_of(excavator_.inlet_hose, boom.inlet_compliance_in3_per_psi);
    HoseEnds outlet = ends_of(excavator_.outlet_hose, boom.outlet_compliance_in3_per_psi);
    HoseLine in = rates_of(excavator_.inlet_hose, inlet.valve_in3_per_psi,
                           cylinder_compliance(excavator_, inlet.cylinder_in3_per_psi, state[inlet_cylinder_psi]),
                           {state[inlet_psi], state[inlet_hose_in3_per_s], state[inlet_cylinder_psi]},
                           flows.inlet_in3_per_s, boom.inlet_area_in2 * velocity + leak);
    HoseLine out = rates_of(excavator_.outlet_hose, outlet.cylinder_in3_per_psi, outlet.valve_in3_per_psi,
                            {state[outlet_cylinder_psi], state[outlet_hose_in3_per_s], state[outlet_psi]},
                            boom.outlet_area_in2 * velocity + leak, drained);
    derivative[inlet_psi] = in.first_psi;
    derivative[inlet_hose_in3_per_s] = in.flow_in3_per_s;
    derivative[inlet_cylinder_psi] = in.second_psi;
    derivative[outlet_cylinder_psi] = out.first_psi;
    derivative[outlet_hose_in3_per_s] = out.flow_in3_per_s;
    derivative[outlet_psi] = out.second_psi;
    derivative[piston_in] = velocity;
    derivative[velocity_in_per_s] = acceleration(state);
    derivative[bristle_in] = bristle_rate_in_per_s(excavator_.friction, velocity, state[bristle_in]);
    derivative[spool_in] = boom.spool_lag_per_s * (desired_spool_in_ - state[spool_in]);
    return {flows.pump_psi > state[inlet_psi], flows.relief_in3_per_s > 0, time_s >= excavator_.leak.start_s,
            boom_orifice_branch(state[spool_in])};
}

} // namespace placedpar::hydraulics
