#include "hydraulics/circuit/flow_constants.hpp"

#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

FlowConstants flow_constants(const Parameters& parameters) {
    return {parameters["flow.orifice"], parameters["flow.pump"], parameters["flow.tank"], parameters["flow.relief"]};
}

FlowConstants flow_constants() { return flow_constants(Parameters::excavator()); }

const FlowConstants& fitted_flow_constants() {
    static const FlowConstants fitted = flow_constants();
    return fitted;
}

const FlowConstants& rounded_flow_constants() {
    static const FlowConstants rounded = [](const Parameters& excavator) {
        return FlowConstants{excavator["flow.rounded.orifice"], excavator["flow.rounded.pump"],
                             excavator["flow.rounded.tank"], excavator["flow.relief"]};
    }(Parameters::excavator());
    return rounded;
}

} // namespace placedpar::hydraulics
