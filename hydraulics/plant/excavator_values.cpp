#include "hydraulics/plant/excavator_values.hpp"

#include "hydraulics/plant/feedforward.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

namespace {

/// Returns the leak of a link. Only the boom can leak (parameters fault.leak*).
PistonLeak leak_of(Link link, const Parameters& parameters) {
    return link == Link::boom ? PistonLeak{parameters["fault.leak"], parameters["fault.leak_start"]} : PistonLeak{};
}

/// Returns the orifices of the valve of link `name` over time (equation B.5), from the parameters two_links.NAME_*.
TimedOrifices two_link_orifices(std::string_view name, const Parameters& parameters) {
    auto value = [&](std::string_view what) { return parameters[fmt::format("two_links.{}_{}", name, what)]; };
    return {.inlet_final_in2 = value("inlet_final"),
            .bypass_rest_in2 = value("bypass_rest"),
            .bypass_final_in2 = value("bypass_final"),
            .outlet_final_in2 = 0,
            .rate_per_s = value("spool_lag"),
            .step_time_s = 0};
}

/// Returns the flow into the link's cylinder that the controller demands, and the link's pressure at this flow. If a
/// check valve shuts the junction's bypass, the link takes the flow of all pumps of the junction.
FlowTarget target_of(const Junction& junction, const FlowConstants& flow, const Parameters& parameters) {
    LinkMechanics link = coupled_mechanics(junction.link, parameters);
    double in = junction.through == Through::nowhere ? junction.pumps * flow.pump_in3_per_s
                                                     : parameters["controller.asked_flow"];
    return {link.steady_inlet_psi(flow.tank_psi, in / link.inlet_area_in2), in};
}

} // namespace

ExcavatorScenario single_boom_scenario(const Parameters& parameters, std::string_view motion) {
    auto value = [&](std::string_view what) { return parameters[fmt::format("{}.{}", motion, what)]; };
    SpoolStep step{value("step_time"), value("spool_desired"), value("spool_ramp")};
    ExcavatorScenario scenario;
    scenario.flow = flow_constants(parameters);
    scenario.configuration = Configuration::a;
    scenario.links = {{.link = Link::boom,
                       .mechanics = single_boom_mechanics(parameters),
                       .valve = SpoolOrifices{value("spool_at_rest"), {step}},
                       .leak = leak_of(Link::boom, parameters)}};
    scenario.duration_s = value("duration");
    scenario.integration_step_s = value("integration_step");
    return scenario;
}

ExcavatorScenario two_link_scenario(const Parameters& parameters) {
    ExcavatorScenario scenario;
    scenario.flow = flow_constants(parameters);
    scenario.configuration = Configuration::a;
    for (Link link : {Link::bucket, Link::boom})
        scenario.links.push_back({link, coupled_mechanics(link, parameters),
                                  two_link_orifices(name_of(link), parameters), leak_of(link, parameters)});
    scenario.duration_s = parameters["two_links.duration"];
    scenario.integration_step_s = parameters["two_links.integration_step"];
    return scenario;
}

ExcavatorScenario step_scenario(Configuration configuration, LinkSet active, const Parameters& parameters) {
    ExcavatorScenario scenario = two_link_scenario(parameters);
    scenario.configuration = configuration;
    scenario.links.clear();
    for (Link link : all_links)
        if (active.contains(link))
            scenario.links.push_back({link, coupled_mechanics(link, parameters),
                                      two_link_orifices("bucket", parameters), leak_of(link, parameters)});
    Circuit circuit = junctions_of(scenario);
    std::vector<FlowTarget> targets;
    for (const Junction& junction : circuit)
        targets.push_back(target_of(junction, scenario.flow, parameters));
    auto openings = openings_for(circuit, targets, scenario.flow, parameters["controller.inlet_drop"],
                                 parameters["controller.bypass_drop"]);
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
