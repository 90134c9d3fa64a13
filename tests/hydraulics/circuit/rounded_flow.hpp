#pragma once

#include "hydraulics/circuit/flow_constants.hpp"

namespace placedpar::test {

/// The values of rounded_flow_constants(): k = 100, Q = 175, P_e = 25.
inline constexpr hydraulics::FlowConstants rounded_flow{100, 175, 25, 4500};

} // namespace placedpar::test
