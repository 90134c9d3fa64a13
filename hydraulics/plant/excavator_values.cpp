#include "hydraulics/plant/excavator_values.hpp"

#include "hydraulics/plant/feedforward.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::hydraulics {

namespace {

/// The valve of B.5 of a link whose row names begin with `name`.
TimedOrifices two_link_orifices(std::string_view name, const Parameters& machine) {
    auto value = [&](std::string_view what) { return machine[fmt::format("two_links.{}_{}", name, what)]; };
    return {value("inlet_final"), value("bypass_rest"), value("bypass_final"), 0, value("spool_lag"), 0};
}

/// The link's pressure when it has taken up the asked flow. Where its junction's bypass is shut, it takes all.
FlowTarget target_of(const Junction& junction, const FlowConstants& flow, const Parameters& parameters) {
    LinkMachine machine = coupled_machine(junction.link, parameters);
    double in = junction.through == Through::nowhere ? junction.pumps * flow.pump_in3_per_s
                                                     : parameters["controller.asked_flow"];
    double velocity = in / machine.inlet_area_in2;
    return {(machine.load_lbf + machine.damping_lbf_s_per_in * velocity) / machine.inlet_area_in2, in};
}

} // namespace

LinkMachine single_boom_machine(const Parameters& machine) {
    return {machine["boom.inlet_area"],        machine["boom.outlet_area"],
            machine["boom.moment_arm"],        machine["boom.mass"],
            machine["boom.damping"],           machine["boom.friction"],
            machine["boom.friction_velocity"], machine["boom.gravity"],
            machine["boom.inlet_compliance"],  machine["boom.outlet_compliance"],
            machine["boom.spool_lag"]};
}

LinkMachine coupled_machine(Link link, const Parameters& machine) {
    auto value = [&](std::string_view what) { return machine[fmt::format("{}.{}", name_of(link), what)]; };
    LinkMachine coupled{};
    coupled.inlet_area_in2 = value("inlet_area");
    coupled.moment_arm_in = value("moment_arm");
    coupled.mass_lbf_s2_per_in = value("mass");
    coupled.damping_lbf_s_per_in = machine[fmt::format("two_links.{}_damping", name_of(link))];
    coupled.friction_velocity_in_per_s = 1; // of no effect without friction
    coupled.load_lbf = value("gravity");
    coupled.inlet_compliance_in3_per_psi = value("inlet_compliance");
    coupled.spool_lag_per_s = value("spool_lag");
    return coupled;
}

ExcavatorScenario single_boom_scenario(const Parameters& machine) {
    ExcavatorScenario scenario;
    SpoolOrifices valve{machine["scenario_a.spool_at_rest"],
                        {{machine["scenario_a.step_time"], machine["scenario_a.spool_desired"]}}};
    scenario.flow = flow_constants(machine);
    scenario.configuration = Configuration::a;
    scenario.links = {{Link::boom, single_boom_machine(machine), valve}};
    scenario.duration_s = machine["scenario_a.duration"];
    scenario.integration_step_s = machine["scenario_a.integration_step"];
    return scenario;
}

ExcavatorScenario two_link_scenario(const Parameters& machine) {
    ExcavatorScenario scenario;
    scenario.flow = flow_constants(machine);
    scenario.configuration = Configuration::a;
    for (Link link : {Link::bucket, Link::boom})
        scenario.links.push_back({link, coupled_machine(link, machine), two_link_orifices(name_of(link), machine)});
    scenario.duration_s = machine["two_links.duration"];
    scenario.integration_step_s = machine["two_links.integration_step"];
    return scenario;
}

ExcavatorScenario step_scenario(Configuration configuration, LinkSet active, const Parameters& machine) {
    ExcavatorScenario scenario = two_link_scenario(machine);
    scenario.configuration = configuration;
    scenario.links.clear();
    for (Link link : all_links)
        if (active.contains(link))
            scenario.links.push_back({link, coupled_machine(link, machine), two_link_orifices("bucket", machine)});
    Circuit circuit = junctions_of(scenario);
    std::vector<FlowTarget> targets;
    for (const Junction& junction : circuit)
        targets.push_back(target_of(junction, scenario.flow, machine));
    auto openings = openings_for(circuit, targets, scenario.flow, machine["controller.inlet_drop"],
                                 machine["controller.bypass_drop"]);
    for (ActiveLink& link : scenario.links)
        for (std::size_t j = 0; j < circuit.size(); ++j)
            if (circuit[j].link == link.link) {
                auto& valve = std::get<TimedOrifices>(link.valve);
                valve.inlet_final_in2 = openings[j].inlet_in2;
                valve.bypass_final_in2 = openings[j].bypass_in2;
            }
    return scenario;
}

} // namespace placedpar::hydraulics
