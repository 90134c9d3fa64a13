#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/flow_split.hpp"

namespace placedpar::hydraulics {

/// Returns the split of the pump's flow while the boom's spool and the cylinder's pressure are constant. REQUIRES:
/// spool_in >= 0.
FlowSplit steady_boom_flow(double spool_in, double inlet_psi, const FlowConstants& constants);

/// Returns the spool position for a flow, as the feedforward of the thesis's controller does (2.3.2): the inverse of
/// steady_boom_flow(). From the opening of the load check valve to the shutting of the bypass, the flow grows with the
/// spool from 0 to the pump's flow, so there is exactly one solution. Throws std::domain_error for a flow outside this
/// range, and for a pressure at which the relief valve opens before the flow is reached.
double boom_spool_for_flow(double inlet_in3_per_s, double inlet_psi, const FlowConstants& constants);

/// The response of the steady flow Q_i to small changes.
struct FlowSensitivity {
    double to_spool_in3_per_s_in;     ///< dQ_i / dx
    double to_pressure_in3_per_s_psi; ///< dQ_i / dP_i, negative
};

/// Returns the derivatives of the flow into the cylinder that steady_boom_flow() computes. REQUIRES: the load check
/// valve is open, and the spool is at least 1e-4 in from each knee of the spool-orifice functions, where the derivative
/// jumps.
FlowSensitivity boom_flow_sensitivity(double spool_in, double inlet_psi, const FlowConstants& constants);

} // namespace placedpar::hydraulics
