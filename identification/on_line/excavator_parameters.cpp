#include "identification/on_line/excavator_parameters.hpp"

#include "hydraulics/plant/measurement.hpp"

#include <fmt/format.h>

namespace placedpar::identification {

using namespace hydraulics;

ExcavatorParameters excavator_parameters(const Parameters& parameters) {
    ExcavatorParameters excavator{sampling_period_s, flow_constants(parameters), link_constants(parameters)};
    for (Link link : all_links)
        excavator.compliance_in3_per_psi[index_of(link)] =
            parameters[fmt::format("{}.inlet_compliance", name_of(link))];
    return excavator;
}

} // namespace placedpar::identification
