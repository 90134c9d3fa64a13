#include "hydraulics/plant/link_mechanics.hpp"

#include "hydraulics/data/units.hpp"

#include <fmt/format.h>

#include <string_view>

namespace placedpar::hydraulics {

double LinkMechanics::joint_deg(double piston_in) const { return piston_in / moment_arm_in * deg_per_rad; }

double LinkMechanics::steady_inlet_psi(double outlet_psi, double velocity_in_per_s) const {
    return (load_lbf + damping_lbf_s_per_in * velocity_in_per_s + outlet_area_in2 * outlet_psi) / inlet_area_in2;
}

LinkMechanics single_boom_mechanics(const Parameters& parameters) {
    return {.inlet_area_in2 = parameters["boom.inlet_area"],
            .outlet_area_in2 = parameters["boom.outlet_area"],
            .moment_arm_in = parameters["boom.moment_arm"],
            .mass_lbf_s2_per_in = parameters["boom.mass"],
            .damping_lbf_s_per_in = parameters["boom.damping"],
            .friction_lbf = parameters["boom.friction"],
            .friction_velocity_in_per_s = parameters["boom.friction_velocity"],
            .load_lbf = parameters["boom.gravity"],
            .inlet_compliance_in3_per_psi = parameters["boom.inlet_compliance"],
            .outlet_compliance_in3_per_psi = parameters["boom.outlet_compliance"],
            .spool_lag_per_s = parameters["boom.spool_lag"]};
}

LinkMechanics coupled_mechanics(Link link, const Parameters& parameters) {
    auto value = [&](std::string_view what) { return parameters[fmt::format("{}.{}", name_of(link), what)]; };
    return {.inlet_area_in2 = value("inlet_area"),
            .outlet_area_in2 = 0,
            .moment_arm_in = value("moment_arm"),
            .mass_lbf_s2_per_in = value("mass"),
            .damping_lbf_s_per_in = parameters[fmt::format("two_links.{}_damping", name_of(link))],
            .friction_lbf = 0,
            .friction_velocity_in_per_s = 1, // ignored without friction
            .load_lbf = value("gravity"),
            .inlet_compliance_in3_per_psi = value("inlet_compliance"),
            .outlet_compliance_in3_per_psi = 0,
            .spool_lag_per_s = value("spool_lag")};
}

} // namespace placedpar::hydraulics
