#pragma once

#include "hydraulics/circuit/junction_flow.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// What the controller wants at a junction: this flow into the link, whose pressure is then this.
struct FlowTarget {
    double link_psi;
    double inlet_in3_per_s;
};

/// The areas at which a circuit gives every link its flow: the feedforward of a computed flow control (2.3.2),
/// for any configuration. Each junction's pressure is the least that leaves `inlet_drop_psi` over its inlet and
/// `bypass_drop_psi` over its bypass: one is met and the other exceeded. Where the circuit keeps the bypass shut,
/// the link takes the junction's whole flow and its target is ignored. Solving the circuit with the result gives
/// the targets back, and no relief valve opens.
/// REQUIRES: one target a junction, flows and drops above 0.
/// Throws UnfitScenario (requirement.hpp) when a junction gets less than its link's flow, or would have to exceed the
/// relief pressure.
std::vector<JunctionOpening> openings_for(const Circuit&, std::span<const FlowTarget>, const FlowConstants&,
                                          double inlet_drop_psi, double bypass_drop_psi);

} // namespace placedpar::hydraulics
