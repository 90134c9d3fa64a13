#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

struct JunctionOpening {
    double link_psi;   ///< P_i of the junction's link
    double inlet_in2;  ///< a_i >= 0
    double bypass_in2; ///< a_e >= 0; ignored where the circuit keeps the bypass shut
};

struct JunctionFlow {
    double psi;              ///< pressure of the junction: P_11, ...
    double inlet_in3_per_s;  ///< Q_i >= 0, into the link
    double bypass_in3_per_s; ///< Q_e >= 0, on to the next junction or the tank
    double relief_in3_per_s; ///< >= 0; only where a pump feeds the junction
};

/// Solves a circuit's steady flow: computes the pressure of each junction of the main valve and the flows that leave
/// it. At every junction the flow from pumps and upstream bypasses leaves through the inlet, the bypass and the relief
/// valve. The flow through an inlet or bypass of area a is k a sqrt(pressure drop), and a check valve prevents backward
/// flow. These are equations B.3 and B.4 with load check valves added.
///
/// The flow through a bypass falls as the pressure beyond the bypass rises. Inflow minus outflow of a junction
/// therefore decreases with the junction's pressure, and has exactly one root. The last junction is solved first. To
/// evaluate its function at a trial pressure, the junctions upstream are solved for that pressure. A junction that only
/// pumps feed is solved in closed form. A solution exists for all areas and pressures.
///
/// If no flow reaches a junction, its pressure is the highest pressure of the junctions whose open bypasses lead to it.
/// Without such junctions, its pressure is the lowest pressure beyond its own open orifices. If all its orifices are
/// shut, its pressure is the tank's. INVARIANT of the result: at every junction, inflow and outflow differ by at most
/// 1e-9 of a pump's flow. REQUIRES: one opening and one result per junction; pump flow > 0, relief pressure finite.
void solve_junctions(const Circuit&, std::span<const JunctionOpening>, const FlowConstants&, std::span<JunctionFlow>);

std::vector<JunctionFlow> solve_junctions(const Circuit&, std::span<const JunctionOpening>, const FlowConstants&);

} // namespace placedpar::hydraulics
