#pragma once

#include "hydraulics/circuit/flow_constants.hpp"

namespace placedpar::test {

/// k 100, Q 175, P_e 25, as the thesis prints them.
inline const hydraulics::FlowConstants& flow = hydraulics::rounded_flow_constants;

} // namespace placedpar::test
