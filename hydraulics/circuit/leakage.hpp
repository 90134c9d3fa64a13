#pragma once

#include <span>

namespace placedpar::hydraulics {

/// A leak through the worn seal of a piston (thesis 2.3.2), which begins at `start_s`. It is one of the simulated
/// faults.
struct PistonLeak {
    double in3_per_s_psi = 0; ///< k_l; 0: the seal is tight
    double start_s = 0;
};

/// Returns the laminar flow across a worn piston seal, from the pump side to the drain side.
inline double leakage_in3_per_s(double leak_in3_per_s_psi, double inlet_psi, double outlet_psi) {
    return leak_in3_per_s_psi * (inlet_psi - outlet_psi);
}

/// Returns by how much an identified compliance, in in^3/psi, is too large if the identification's model has no leak. A
/// leak can so be recognised from an apparent growth of the compliance.
///
/// The true flow is Q_i = C_i dP_i/dt + A_i dX/dt + Q_l. The model without a leak has C_i' dP_i/dt in place of the
/// first and the last term. (The thesis prints equation 2.5 with both C_i' and Q_l, but equation 2.7 does not follow
/// from that form.) At one instant
///   C_i' - C_i = Q_l / (dP_i/dt),
/// and equation 2.8 gives a lower bound of this difference. Over a window of samples, the C_i' with the least squared
/// error satisfies
///   C_i' - C_i = sum(Q_l dP_i/dt) / sum((dP_i/dt)^2).
/// Throws std::invalid_argument if the numbers of flows and slopes differ, or if all slopes are 0, so that the quotient
/// is undefined.
double apparent_compliance_change(std::span<const double> leak_in3_per_s, std::span<const double> slope_psi_per_s);

} // namespace placedpar::hydraulics
