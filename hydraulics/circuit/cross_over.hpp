#pragma once

#include "hydraulics/circuit/main_valve.hpp"

namespace placedpar::hydraulics {

/// The pressure differences at which the valves of the cross-over network move.
///
/// Each pump feeds one branch: branch 1 has the bucket and the boom, branch 2 the swing and the stick. Surplus oil is
/// oil that a branch's own links do not take. Behind the boom and behind the stick, a valve leads this oil to the tank,
/// or to the second link of the other branch. P13 is the pressure at the boom and P23 the pressure at the stick
/// (main_valve.hpp). If P13 exceeds P23 by `shift_psi`, branch 1 receives the surplus of branch 2. When P23 then
/// exceeds P13 by `release_psi`, the surplus of branch 2 goes to the tank again. Between these two limits the valve
/// stays in its position. The surplus of branch 1 follows the same rule with P13 and P23 exchanged.
struct CrossOverLimits {
    double shift_psi;   ///< > 0
    double release_psi; ///< > 0
    double seat_psi;    ///< >= 0: an open check valve shuts if the pressure behind it exceeds the pressure before it by
                        ///< this difference
};

/// Reads the parameters cross_over.*.
CrossOverLimits cross_over_limits(const Parameters& parameters);

/// Returns the configuration that follows from the configuration `now` at these pressures. P12 and P22 are the
/// pressures before the check valves of the two branches. The configurations are:
///
///     a      both surpluses go to the tank
///     b, d   the surplus of branch 2 goes to the boom; in b, branch 1's check valve is shut, so P13 > P12
///     c, e   the surplus of branch 1 goes to the stick; in c, branch 2's check valve is shut, so P23 > P22
Configuration next_configuration(Configuration now, const BranchPressures&, const CrossOverLimits&);

} // namespace placedpar::hydraulics
