#pragma once

#include "hydraulics/circuit/flow_constants.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// One instant of a boom's record, for the cross-check by simulation.
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

/// Computes the pressure P_i that a compliance would have given with the recorded spool and motion (the cross-check of
/// Figures 3.7 and 3.8): C_i P_i' = Q_i(P_i, spool) - A_i v, with the flow split 3.1 to 3.3. Between samples, spool and
/// velocity are interpolated linearly. The method is Runge-Kutta of order 4 (Boost.Odeint) in steps of at most
/// `step_s`. Returns one pressure per sample, beginning with `initial_psi`. Throws std::invalid_argument unless times
/// ascend and compliance and step are above 0.
std::vector<double> replay_pressure(std::span<const ReplaySample>, const ReplayCircuit&, double initial_psi,
                                    double step_s);

} // namespace placedpar::hydraulics
