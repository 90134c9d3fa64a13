#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// What a junction finds open, and against which pressure.
struct JunctionOpening {
    double link_psi;   ///< P_i of the junction's link
    double inlet_in2;  ///< a_i >= 0
    double bypass_in2; ///< a_e >= 0; of no effect where the circuit keeps the bypass shut
};

/// The flow at one junction.
struct JunctionFlow {
    double psi;              ///< P_11, ...
    double inlet_in3_per_s;  ///< Q_i >= 0, into the link
    double bypass_in3_per_s; ///< Q_e >= 0, on to the next junction or the tank
    double relief_in3_per_s; ///< >= 0; only where a pump feeds the junction
};

/// Solves a circuit's steady flow: at every junction the flow from pumps and from upstream bypasses leaves through
/// the inlet, the bypass and the relief valve; each flow is k a sqrt(drop) and, by its check valve, never
/// backwards (equations B.3 and B.4, with the load checks that they leave out).
///
/// The flow through a bypass falls as the pressure beyond it rises. So, from the last junction upstream, each
/// junction's pressure is the one root of a decreasing function; to evaluate it at a trial pressure, the junctions
/// upstream are solved for that pressure. A junction fed by pumps alone is solved in closed form. There is a
/// solution for all areas and pressures.
///
/// A junction that no flow reaches has the highest pressure of the junctions whose open bypasses lead there; if
/// there is none, the lowest pressure beyond its own open orifices; if these are shut, too, the tank's.
/// INVARIANT of the result: flow is conserved at every junction to 1e-9 of a pump's flow.
/// REQUIRES: one opening a junction, written to as many flows; pump flow > 0, relief pressure finite.
void solve_junctions(const Circuit&, std::span<const JunctionOpening>, const FlowConstants&, std::span<JunctionFlow>);

std::vector<JunctionFlow> solve_junctions(const Circuit&, std::span<const JunctionOpening>, const FlowConstants&);

} // namespace placedpar::hydraulics
