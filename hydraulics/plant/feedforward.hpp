#pragma once

#include "hydraulics/circuit/junction_flow.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// The controller's target at a junction: the flow into the link, and the link's pressure at that flow.
struct FlowTarget {
    double link_psi;
    double inlet_in3_per_s;
};

/// Returns the orifice areas at which a circuit gives every link its target flow. A controller sets these areas without
/// waiting for an error of the motion (thesis 2.3.2). Each junction has the lowest pressure that leaves at least
/// `inlet_drop_psi` over its inlet and `bypass_drop_psi` over its bypass. If the circuit keeps a bypass shut, its link
/// takes the junction's whole flow, whatever the target flow is. Otherwise solve_junctions() with these areas gives the
/// target flows again, and no relief valve opens. REQUIRES: one target per junction, flows and drops above 0. Throws
/// UnfitScenario (requirement.hpp) if a junction receives less flow than its link needs, or would need a pressure above
/// the relief pressure.
std::vector<JunctionOpening> openings_for(const Circuit&, std::span<const FlowTarget>, const FlowConstants&,
                                          double inlet_drop_psi, double bypass_drop_psi);

} // namespace placedpar::hydraulics
