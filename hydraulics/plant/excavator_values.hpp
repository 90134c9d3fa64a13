#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/excavator_scenario.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// Scenarios with the numbers of excavator.csv.

/// The boom is held, then the operator asks for 4 deg/s: with spool, leak and drain side, in configuration a. The
/// motion follows the rows `motion`.*: scenario_a, a step, or scenario_b, a ramp.
ExcavatorScenario single_boom_scenario(const Parameters& parameters = Parameters::excavator(),
                                       std::string_view motion = "scenario_a");

/// Scenario R2, the simulation of 3.2: bucket and boom, branch 1 of configuration a, a step of both by B.5.
ExcavatorScenario two_link_scenario(const Parameters& parameters = Parameters::excavator());

/// The links `active` in any configuration, with a step of all: B.5 with the final areas that give each the flow
/// that the controller asks for. REQUIRES: a link is active.
ExcavatorScenario step_scenario(Configuration configuration, LinkSet active,
                                const Parameters& parameters = Parameters::excavator());

} // namespace placedpar::hydraulics
