#include "hydraulics/plant/boom_motion.hpp"

#include "hydraulics/plant/excavator_motion.hpp"

namespace placedpar::hydraulics {

namespace {

LinkMachine link_machine(const BoomMachine& boom) {
    LinkMachine machine{};
    machine.inlet_area_in2 = boom.inlet_area_in2;
    machine.outlet_area_in2 = boom.outlet_area_in2;
    machine.moment_arm_in = boom.moment_arm_in;
    machine.mass_lbf_s2_per_in = boom.mass_lbf_s2_per_in;
    machine.damping_lbf_s_per_in = boom.damping_lbf_s_per_in;
    machine.friction_lbf = boom.friction_lbf;
    machine.friction_velocity_in_per_s = boom.friction_velocity_in_per_s;
    machine.load_lbf = boom.gravity_lbf;
    machine.inlet_compliance_in3_per_psi = boom.inlet_compliance_in3_per_psi;
    machine.outlet_compliance_in3_per_psi = boom.outlet_compliance_in3_per_psi;
    machine.spool_lag_per_s = boom.spool_lag_per_s;
    return machine;
}

ExcavatorScenario excavator_scenario(const BoomScenario& boom) {
    SpoolOrifices valve{boom.spool_at_rest_in, {{boom.step_time_s, boom.spool_desired_in, boom.ramp_s}}};
    ExcavatorScenario scenario;
    scenario.flow = boom.flow;
    scenario.configuration = Configuration::a;
    scenario.links = {{Link::boom, link_machine(boom.machine), valve, {boom.leak_in3_per_s_psi, boom.leak_start_s}}};
    scenario.duration_s = boom.duration_s;
    scenario.integration_step_s = boom.integration_step_s;
    return scenario;
}

} // namespace

std::vector<BoomState> simulate_boom(const BoomScenario& scenario) {
    std::vector<BoomState> motion;
    simulate_excavator(excavator_scenario(scenario), [&](ExcavatorState&& state) {
        const LinkState& boom = state.links.front();
        motion.push_back(
            {state.time_s, boom.inlet_psi, boom.outlet_psi, boom.piston_in, boom.velocity_in_per_s, boom.spool_in});
    });
    return motion;
}

} // namespace placedpar::hydraulics
