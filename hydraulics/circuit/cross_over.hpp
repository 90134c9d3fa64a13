#pragma once

#include "hydraulics/circuit/main_valve.hpp"

namespace placedpar::hydraulics {

/// The pressure differences at which the valves of the cross-over network move.
///
/// Behind the boom and behind the stick, a valve leads the surplus flow to the tank, or to the other branch's second
/// link. If P_n3 of a branch exceeds that of the other branch by `shift_psi`, the branch gets the surplus of the other.
/// If P_n3 of the other branch is then higher by `release_psi`, the other branch works itself, and its valve goes back.
/// Between these two limits the valve stays in its position.
struct CrossOverLimits {
    double shift_psi;   ///< > 0
    double release_psi; ///< > 0
    double seat_psi;    ///< >= 0: a check valve counts as shut if the pressure behind it is higher by this
};

/// Reads the rows cross_over.*.
CrossOverLimits cross_over_limits(const Parameters& parameters);

/// Returns the configuration that follows from `now` at these pressures. The configurations are also the states of the
/// hysteresis:
///
///     a      both surpluses go to the tank
///     b, d   the surplus of branch 2 goes to the boom; in b, branch 1's check valve is shut, so P13 > P12
///     c, e   the surplus of branch 1 goes to the stick; in c, branch 2's check valve is shut, so P23 > P22
Configuration next_configuration(Configuration now, const BranchPressures&, const CrossOverLimits&);

} // namespace placedpar::hydraulics
