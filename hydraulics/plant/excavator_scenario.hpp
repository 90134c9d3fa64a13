#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/leakage.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/link_valve.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// A moving link of a simulated excavator, with its valve and its leak.
struct ActiveLink {
    Link link;
    LinkMechanics mechanics;
    LinkValve valve;
    PistonLeak leak = {};
};

/// What simulate_excavator() (excavator_motion.hpp) simulates: any set of links in any configuration of the main valve.
struct ExcavatorScenario {
    FlowConstants flow{};
    Configuration configuration{};
    std::vector<ActiveLink> links; ///< each link at most once
    double duration_s = 0;         ///< > 0
    double integration_step_s = 0; ///< > 0; also the interval between the states that are kept
};

/// If a value is invalid, throws an UnfitScenario (requirement.hpp) that names the value and its valid range.
void require_valid(const ExcavatorScenario&);

/// Returns the junctions of all active links. Junctions of one circuit, between which oil can flow, are neighbours,
/// with upstream junctions first.
Circuit junctions_of(const ExcavatorScenario&);

} // namespace placedpar::hydraulics
