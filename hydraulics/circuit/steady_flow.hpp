#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/flow_split.hpp"

namespace placedpar::hydraulics {

/// Returns how the pump's flow divides while the boom's spool and the cylinder's pressure are constant. REQUIRES:
/// spool_in >= 0.
FlowSplit steady_boom_flow(double spool_in, double inlet_psi, const FlowConstants& constants);

/// Returns the spool position that gives this flow into the cylinder, the inverse of steady_boom_flow(). The
/// feedforward of the thesis's controller needs this position (2.3.2). As the spool moves from the opening of the load
/// check valve to the shutting of the bypass, the flow grows from 0 to the pump's flow. Therefore exactly one position
/// is the solution. Throws std::domain_error if the flow is outside this range, or if the relief valve opens before the
/// flow is reached.
double boom_spool_for_flow(double inlet_in3_per_s, double inlet_psi, const FlowConstants& constants);

/// How much the steady flow Q_i into the cylinder changes with the spool and the pressure.
struct FlowSensitivity {
    double to_spool_in3_per_s_in;     ///< dQ_i / dx
    double to_pressure_in3_per_s_psi; ///< dQ_i / dP_i, negative
};

/// Returns the derivatives of the flow into the cylinder that steady_boom_flow() computes. REQUIRES: the load check
/// valve is open. The spool is at least 1e-4 in from each knee of boom_orifices.hpp, because the derivative jumps
/// there.
FlowSensitivity boom_flow_sensitivity(double spool_in, double inlet_psi, const FlowConstants& constants);

} // namespace placedpar::hydraulics
