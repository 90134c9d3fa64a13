#include "identification/on_line/excavator_parameters.hpp"

#include "hydraulics/plant/measurement.hpp"

namespace placedpar::identification {

using namespace hydraulics;

ExcavatorParameters excavator_parameters(const Parameters& parameters) {
    return {sampling_period_s, flow_constants(parameters), link_constants(parameters)};
}

} // namespace placedpar::identification
