#include "identification/on_line/excavator_parameters.hpp"

#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/parameters.hpp"

#include <array>

namespace placedpar::identification {

using namespace hydraulics;

PerLink<LinkParameters> default_link_parameters() {
    LinkCalibrations calibrations = link_calibrations(Parameters::excavator());
    PerLink<LinkParameters> parameters;
    for (Link link : all_links) {
        const LinkCalibration& calibration = calibrations[index_of(link)];
        parameters[index_of(link)] = {calibration.piston_in3_per_rad, calibration.spool_lag_per_s};
    }
    return parameters;
}

bool operator==(const ExcavatorParameters& a, const ExcavatorParameters& b) {
    auto numbers = [](const FlowConstants& flow) {
        return std::array{flow.orifice_in3_per_s_in2_sqrt_psi, flow.pump_in3_per_s, flow.tank_psi, flow.relief_psi};
    };
    return a.period_s == b.period_s && numbers(a.flow) == numbers(b.flow) && a.links == b.links;
}

} // namespace placedpar::identification
