#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/leakage.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/link_valve.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// A link that moves, and what moves it.
struct ActiveLink {
    Link link;
    LinkMechanics mechanics;
    LinkValve valve;
    PistonLeak leak = {};
};

/// What excavator_motion.hpp simulates: any set of links in any configuration of the main valve.
struct ExcavatorScenario {
    FlowConstants flow{};
    Configuration configuration{};
    std::vector<ActiveLink> links; ///< each link at most once
    double duration_s = 0;         ///< > 0
    double integration_step_s = 0; ///< > 0; also how often the motion is noted
};

/// Throws UnfitScenario (requirement.hpp), which says which value cannot be simulated, and what is expected.
void require_valid(const ExcavatorScenario&);

/// The junctions of all active links, circuit after circuit, each upstream before downstream.
Circuit junctions_of(const ExcavatorScenario&);

} // namespace placedpar::hydraulics
