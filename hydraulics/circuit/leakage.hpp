#pragma once

#include <span>

namespace placedpar::hydraulics {

/// A leak across a piston (2.3.2) that begins at `start_s`.
struct PistonLeak {
    double in3_per_s_psi = 0; ///< k_l; 0: the seal is tight
    double start_s = 0;
};

/// Returns the laminar flow across a worn piston seal, from the pump side to the drain side.
inline double leakage_in3_per_s(double leak_in3_per_s_psi, double inlet_psi, double outlet_psi) {
    return leak_in3_per_s_psi * (inlet_psi - outlet_psi);
}

/// Returns the apparent growth of the compliance, in in^3/psi, in a model that leaves out the leak.
///
/// The flow is Q_i = C_i dP_i/dt + A_i dX/dt + Q_l; in the model, C_i' dP_i/dt replaces the first and the last term
/// together. (The thesis prints equation 2.5 with both C_i' and Q_l, from which equation 2.7 would not follow.) At one
/// instant
///   C_i' - C_i = Q_l / (dP_i/dt),
/// for which equation 2.8 gives the lower bound. Over a window, the C_i' with the least error satisfies
///   C_i' - C_i = sum(Q_l dP_i/dt) / sum((dP_i/dt)^2).
/// Throws std::invalid_argument if the numbers of flows and slopes differ, or if all slopes are 0, so that the quotient
/// is undefined.
double apparent_compliance_change(std::span<const double> leak_in3_per_s, std::span<const double> slope_psi_per_s);

} // namespace placedpar::hydraulics
