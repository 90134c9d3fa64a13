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

/// Solves a circuit's steady flow. At every junction the flow from pumps and upstream bypasses leaves through the
/// inlet, the bypass and the relief valve. Each flow is k a sqrt(drop), and a check valve prevents backward flow. These
/// are equations B.3 and B.4 with load check valves added.
///
/// The flow through a bypass falls as the pressure beyond it rises. The pressure of each junction is therefore the only
/// root of a decreasing function, inflow minus outflow; the last junction is solved first. To evaluate the function at
/// a trial pressure, the junctions upstream are solved for that pressure. A junction fed only by pumps is solved in
/// closed form. There is a solution for all areas and pressures.
///
/// A junction that no flow reaches has the highest pressure of the junctions whose open bypasses lead to it. If there
/// are none, it has the lowest pressure beyond its own open orifices, or the tank's pressure if all its orifices are
/// shut. INVARIANT of the result: flow is conserved at every junction to 1e-9 of a pump's flow. REQUIRES: one opening
/// and one result per junction; pump flow > 0, relief pressure finite.
void solve_junctions(const Circuit&, std::span<const JunctionOpening>, const FlowConstants&, std::span<JunctionFlow>);

std::vector<JunctionFlow> solve_junctions(const Circuit&, std::span<const JunctionOpening>, const FlowConstants&);

} // namespace placedpar::hydraulics
