#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/junction_flow.hpp"

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// The pressures on which the configuration depends (2.4). We have the text of Figure 2.10 without its drawing, so this
/// is our interpretation: branch n is the line from its pump past its first link, a check valve, and the junction of
/// its second link.
struct BranchPressures {
    double p12_psi; ///< branch 1 before its check valve: past the bucket
    double p13_psi; ///< branch 1 behind its check valve: at the boom
    double p22_psi; ///< branch 2 before its check valve: past the swing
    double p23_psi; ///< branch 2 behind its check valve: at the stick
};

/// The pressure differences at which the valves of the cross-over network move.
///
/// Behind the boom and behind the stick, a valve leads the surplus flow to the tank, or to the other branch's second
/// link. The branch whose P_n3 exceeds the other's by `shift_psi` gets the other's surplus. The valve goes back when
/// the other branch's P_n3 exceeds this branch's by `release_psi`, because the other branch then works itself. Between
/// the two it stays as it is.
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

/// Returns the pressures of the steady flow through the whole main valve in a configuration.
BranchPressures branch_pressures(Configuration, const PerLink<JunctionOpening>&, const FlowConstants&);

/// Returns the configuration in which the main valve's pressures call for no further change, from `now` on, with
/// constant openings. If
/// the valves would move for ever, returns the configuration after eight moves.
Configuration settled_configuration(Configuration now, const PerLink<JunctionOpening>&, const FlowConstants&,
                                    const CrossOverLimits&);

} // namespace placedpar::hydraulics
