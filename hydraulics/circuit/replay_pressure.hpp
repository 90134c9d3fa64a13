#pragma once

#include "hydraulics/circuit/flow_constants.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// One instant of a record of the boom, from which a simulation computes the pressure that an identified compliance
/// would have caused.
struct ReplaySample {
    double time_s;
    double spool_in;
    double velocity_in_per_s; ///< velocity of the piston
};

struct ReplayCircuit {
    FlowConstants flow;
    double inlet_area_in2;               ///< A_i
    double inlet_compliance_in3_per_psi; ///< C_i, as identified
};

/// Computes the pressure P_i that a compliance would have caused with the recorded spool and motion. If this pressure
/// is near the recorded pressure, the compliance is confirmed (the cross-check of Figures 3.7 and 3.8). The equation is
/// C_i P_i' = Q_i(P_i, spool) - A_i v, where Q_i is the share of the pump's flow that enters the cylinder (3.1 to 3.3).
/// Between samples, spool and velocity are interpolated linearly. The method is Runge-Kutta of order 4 (Boost.Odeint)
/// in steps of at most `step_s`. Returns one pressure per sample, beginning with `initial_psi`. Throws
/// std::invalid_argument unless times rise and compliance and step are above 0.
std::vector<double> replay_pressure(std::span<const ReplaySample>, const ReplayCircuit&, double initial_psi,
                                    double step_s);

} // namespace placedpar::hydraulics
