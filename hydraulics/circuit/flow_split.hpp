#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/orifice.hpp"

namespace placedpar::hydraulics {

/// An orifice that leads to a known pressure.
struct Outlet {
    double conductance; ///< k a, in^3/s per root psi
    double psi;         ///< pressure beyond the orifice
};

/// Returns the flow through the outlet; 0 if `psi`, the pressure before the orifice, is below the outlet's pressure.
inline double flow_through(const Outlet& outlet, double psi) {
    return orifice_flow(outlet.conductance, psi - outlet.psi);
}

/// The flows that leave a junction.
struct FlowSplit {
    double pump_psi;         ///< P
    double inlet_in3_per_s;  ///< Q_i >= 0
    double bypass_in3_per_s; ///< Q_e >= 0
    double
        relief_in3_per_s; ///< over the relief valve; INVARIANT: inlet, bypass and relief flow add up to the pump's flow
};

/// Computes, in closed form, how `flow_in3_per_s` splits between two outlets, and the pressure before them. Neither
/// outlet lets flow back. At the relief pressure, the rest of the flow passes through the relief valve. REQUIRES:
/// conductances not below 0, flow > 0.
FlowSplit split_flow(const Outlet& inlet, const Outlet& bypass, double flow_in3_per_s, double relief_psi);

/// Solves equations 3.1 to 3.3 for P, Q_i and Q_e. The equations have no solution if the bypass takes the whole flow at
/// a pressure below P_i. In that case a load check valve keeps Q_i at 0, as in the machine. REQUIRES: inlet_in2 >= 0,
/// bypass_in2 >= 0, pump flow > 0.
FlowSplit split_flow(double inlet_in2, double bypass_in2, double inlet_psi, const FlowConstants& constants);

/// Returns the pump pressure with the inlet shut; infinite if the bypass is shut too. The path to the cylinder is
/// predicted to be open if this pressure exceeds the cylinder's pressure.
double bypass_only_psi(double bypass_in2, const FlowConstants& constants);

} // namespace placedpar::hydraulics
