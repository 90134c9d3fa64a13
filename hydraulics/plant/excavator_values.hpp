#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/excavator_scenario.hpp"

namespace placedpar::hydraulics {

/// Machines and scenarios with the numbers of excavator.csv.

/// The boom of the single-link experiments, with its drain side.
LinkMachine single_boom_machine(const Parameters& machine = Parameters::excavator());

/// A link where several move (Figures 3.9 to 3.11): no drain side, damping in place of friction, as appendix B has
/// it. The swing is a motor: its area times its moment arm is what it takes up a radian.
LinkMachine coupled_machine(Link link, const Parameters& machine = Parameters::excavator());

/// Scenario A: the boom is held, then asked for 4 deg/s. What boom_motion.hpp simulates, here with its events.
ExcavatorScenario single_boom_scenario(const Parameters& machine = Parameters::excavator());

/// Scenario R2, the simulation of 3.2: bucket and boom, branch 1 of configuration a, a step of both by B.5.
ExcavatorScenario two_link_scenario(const Parameters& machine = Parameters::excavator());

/// The links `active` in any configuration, with a step of all: B.5 with the final areas that give each the flow
/// that the controller asks for. REQUIRES: a link is active.
ExcavatorScenario step_scenario(Configuration configuration, LinkSet active,
                                const Parameters& machine = Parameters::excavator());

} // namespace placedpar::hydraulics
