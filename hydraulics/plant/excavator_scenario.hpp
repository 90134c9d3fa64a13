#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/leakage.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/link_valve.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// A moving link, with its valve and its leak.
struct ActiveLink {
    Link link;
    LinkMechanics mechanics;
    LinkValve valve;
    PistonLeak leak = {};
};

/// The input of excavator_motion.hpp: any set of links in any configuration of the main valve.
struct ExcavatorScenario {
    FlowConstants flow{};
    Configuration configuration{};
    std::vector<ActiveLink> links; ///< each link at most once
    double duration_s = 0;         ///< > 0
    double integration_step_s = 0; ///< > 0; also the interval between the states that are kept
};

/// If a value is invalid, throws an UnfitScenario (requirement.hpp) that names the value and its valid range.
void require_valid(const ExcavatorScenario&);

/// Returns the junctions of all active links, circuit by circuit; within a circuit, upstream junctions come first.
Circuit junctions_of(const ExcavatorScenario&);

} // namespace placedpar::hydraulics
