#pragma once

#include "hydraulics/flow_constants.hpp"

namespace placedpar {

/// Where the pump's flow goes.
struct FlowSplit {
    double pump_psi;         // P
    double inlet_in3_per_s;  // Q_i >= 0
    double bypass_in3_per_s; // Q_e >= 0
    double relief_in3_per_s; // over the relief valve; INVARIANT: the three add up to the pump's flow
};

/// Solves equations 3.1 to 3.3 for P, Q_i and Q_e in closed form. The thesis's equations have no solution
/// when the bypass takes the whole flow at a pressure below P_i; here a load check valve then keeps Q_i at 0,
/// as in the machine. At the relief pressure the rest of the flow goes over the relief valve. REQUIRES:
/// inlet_in2 >= 0, bypass_in2 >= 0, pump flow > 0.
FlowSplit split_flow(double inlet_in2, double bypass_in2, double inlet_psi, const FlowConstants& constants);

/// The pump pressure if the inlet were shut; infinite when the bypass is shut too. The path to the cylinder
/// is predicted open when this exceeds the cylinder's pressure.
double bypass_only_psi(double bypass_in2, const FlowConstants& constants);

} // namespace placedpar
