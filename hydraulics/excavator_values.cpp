#include "hydraulics/excavator_values.hpp"

#include "hydraulics/feedforward.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

namespace {

/// The link's pressure when it has taken up the asked flow. Where its junction's bypass is shut, it takes all.
FlowTarget target_of(const Junction& junction, const FlowConstants& flow) {
    const LinkMachine& machine = machine_of(junction.link);
    double in = junction.through == Through::nowhere ? junction.pumps * flow.pump_in3_per_s : asked_in3_per_s;
    double velocity = in / machine.inlet_area_in2;
    return {(machine.load_lbf + machine.damping_lbf_s_per_in * velocity) / machine.inlet_area_in2, in};
}

} // namespace

ExcavatorScenario step_scenario(Configuration configuration, LinkSet active) {
    ExcavatorScenario scenario = two_link_scenario();
    scenario.configuration = configuration;
    scenario.links.clear();
    for (MachineLink link : all_links)
        if (active.contains(link))
            scenario.links.push_back({link, machine_of(link), bucket_orifices});
    Circuit circuit = junctions_of(scenario);
    std::vector<FlowTarget> targets;
    for (const Junction& junction : circuit)
        targets.push_back(target_of(junction, scenario.flow));
    auto openings = openings_for(circuit, targets, scenario.flow, inlet_drop_psi, bypass_drop_psi);
    for (ActiveLink& link : scenario.links)
        for (std::size_t j = 0; j < circuit.size(); ++j)
            if (circuit[j].link == link.link) {
                auto& valve = std::get<TimedOrifices>(link.valve);
                valve.inlet_final_in2 = openings[j].inlet_in2;
                valve.bypass_final_in2 = openings[j].bypass_in2;
            }
    return scenario;
}

} // namespace placedpar
