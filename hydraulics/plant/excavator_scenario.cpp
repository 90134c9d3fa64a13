#include "hydraulics/plant/excavator_scenario.hpp"

#include "hydraulics/plant/requirement.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar::hydraulics {

namespace {

constexpr Requirement scenario_needs{"excavator scenario"};

/// Returns a text such as "the boom's mass".
std::string its(std::string_view link, std::string_view what) { return fmt::format("the {}'s {}", link, what); }

void require_valid(const LinkMechanics& mechanics, std::string_view link) {
    scenario_needs.positive(its(link, "inlet area"), mechanics.inlet_area_in2);
    scenario_needs.not_negative(its(link, "outlet area"), mechanics.outlet_area_in2);
    scenario_needs.positive(its(link, "moment arm"), mechanics.moment_arm_in);
    scenario_needs.positive(its(link, "mass"), mechanics.mass_lbf_s2_per_in);
    scenario_needs.not_negative(its(link, "damping"), mechanics.damping_lbf_s_per_in);
    scenario_needs.not_negative(its(link, "friction"), mechanics.friction_lbf);
    scenario_needs.positive(its(link, "friction velocity"), mechanics.friction_velocity_in_per_s);
    scenario_needs.positive(its(link, "inlet compliance"), mechanics.inlet_compliance_in3_per_psi);
    if (mechanics.outlet_area_in2 > 0)
        scenario_needs.positive(its(link, "outlet compliance"), mechanics.outlet_compliance_in3_per_psi);
    scenario_needs.positive(its(link, "spool lag"), mechanics.spool_lag_per_s);
    scenario_needs.finite(its(link, "load"), mechanics.load_lbf);
}

void require_valid(const TimedOrifices& valve, std::string_view link) {
    scenario_needs.not_negative(its(link, "final inlet orifice"), valve.inlet_final_in2);
    scenario_needs.not_negative(its(link, "bypass orifice at rest"), valve.bypass_rest_in2);
    scenario_needs.not_negative(its(link, "final bypass orifice"), valve.bypass_final_in2);
    scenario_needs.not_negative(its(link, "final outlet orifice"), valve.outlet_final_in2);
    scenario_needs.positive(its(link, "valve rate"), valve.rate_per_s);
    scenario_needs.finite(its(link, "step time"), valve.step_time_s);
}

void require_valid(const SpoolOrifices& valve, std::string_view link) {
    scenario_needs.not_negative(its(link, "spool at rest"), valve.rest_in);
    for (std::size_t i = 0; i < valve.steps.size(); ++i) {
        scenario_needs.not_negative(its(link, "desired spool"), valve.steps[i].desired_in);
        scenario_needs.not_negative(its(link, "ramp"), valve.steps[i].ramp_s);
        if (i > 0 && !(valve.steps[i].time_s > valve.steps[i - 1].time_s + valve.steps[i - 1].ramp_s))
            scenario_needs.refuse(its(link, "step time"), valve.steps[i].time_s,
                                  "a time after the end of the previous step");
    }
}

} // namespace

void require_valid(const ExcavatorScenario& scenario) {
    scenario_needs.positive("the integration step", scenario.integration_step_s);
    scenario_needs.positive("the duration", scenario.duration_s);
    scenario_needs.kept_whole(scenario.duration_s, scenario.integration_step_s);
    scenario_needs.positive("the orifice constant", scenario.flow.orifice_in3_per_s_in2_sqrt_psi);
    scenario_needs.positive("the pump flow", scenario.flow.pump_in3_per_s);
    scenario_needs.positive("the relief pressure", scenario.flow.relief_psi);
    if (scenario.links.empty())
        throw UnfitScenario("excavator scenario: no link is active, expected at least one");
    LinkSet seen;
    for (const ActiveLink& active : scenario.links) {
        std::string_view name = name_of(active.link);
        if (seen.contains(active.link))
            throw UnfitScenario(
                fmt::format("excavator scenario: the {} is listed twice, expected each link once", name));
        seen.insert(active.link);
        require_valid(active.mechanics, name);
        std::visit([name](const auto& valve) { require_valid(valve, name); }, active.valve);
        scenario_needs.not_negative(its(name, "leak"), active.leak.in3_per_s_psi);
    }
}

Circuit junctions_of(const ExcavatorScenario& scenario) {
    LinkSet active;
    for (const ActiveLink& link : scenario.links)
        active.insert(link.link);
    Circuit all;
    for (LinkSet group : coupled_groups(scenario.configuration)) {
        if ((group & active).empty())
            continue;
        std::size_t first = all.size();
        for (Junction junction : circuit_of(scenario.configuration, group & active)) {
            junction.next += junction.through == Through::junction ? first : 0;
            all.push_back(junction);
        }
    }
    return all;
}

} // namespace placedpar::hydraulics
