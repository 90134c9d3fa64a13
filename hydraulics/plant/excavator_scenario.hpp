#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/plant/link_machine.hpp"
#include "hydraulics/plant/link_valve.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// A link that moves, and what moves it.
struct ActiveLink {
    Link link;
    LinkMachine machine;
    LinkValve valve;
    PistonLeak leak = no_leak;
};

/// What excavator_motion.hpp simulates: any set of links in any configuration of the main valve.
struct ExcavatorScenario {
    FlowConstants flow{};
    Configuration configuration{};
    std::vector<ActiveLink> links; // each link at most once
    double duration_s = 0;         // > 0
    double integration_step_s = 0; // > 0; also how often the motion is noted
};

/// Throws std::invalid_argument that says which value cannot be simulated, and what would do.
void require_valid(const ExcavatorScenario&);

/// The junctions of all active links, circuit after circuit, each upstream before downstream.
Circuit junctions_of(const ExcavatorScenario&);

} // namespace placedpar::hydraulics
