#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/orifice.hpp"

namespace placedpar::hydraulics {

/// An orifice that leads to a known pressure.
struct Outlet {
    double conductance; ///< k a, in^3/s per root psi
    double psi;         ///< pressure beyond the orifice
};

/// Returns the flow through the outlet. `psi` is the pressure before the orifice. If it is below the outlet's pressure,
/// the flow is 0.
inline double flow_through(const Outlet& outlet, double psi) {
    return orifice_flow(outlet.conductance, psi - outlet.psi);
}

/// The flows into which a pump's flow divides at a junction of the main valve.
struct FlowSplit {
    double pump_psi;         ///< P
    double inlet_in3_per_s;  ///< Q_i >= 0
    double bypass_in3_per_s; ///< Q_e >= 0
    double relief_in3_per_s; ///< through the relief valve; INVARIANT: inlet, bypass and relief flow add up to the
                             ///< pump's flow
};

/// Computes, in closed form, how `flow_in3_per_s` splits between two outlets, and the pressure before the outlets.
/// Neither outlet lets oil flow back. If the pressure would exceed `relief_psi`, the relief valve takes the flow that
/// the outlets do not take at this pressure. REQUIRES: conductances >= 0, flow > 0.
FlowSplit split_flow(const Outlet& inlet, const Outlet& bypass, double flow_in3_per_s, double relief_psi);

/// Solves equations 3.1 to 3.3, the balance of flow at the boom's junction, for P, Q_i and Q_e. The equations have no
/// solution if the bypass takes the pump's whole flow at a pressure below the cylinder's pressure P_i. In that case Q_i
/// is 0, because the machine's load check valve shuts. REQUIRES: inlet_in2 >= 0, bypass_in2 >= 0, pump flow > 0.
FlowSplit split_flow(double inlet_in2, double bypass_in2, double inlet_psi, const FlowConstants& constants);

/// Returns the pump's pressure while the inlet is shut. If the bypass is shut too, the result is infinite. The load
/// check valve opens if this pressure exceeds the cylinder's pressure.
double bypass_only_psi(double bypass_in2, const FlowConstants& constants);

} // namespace placedpar::hydraulics
