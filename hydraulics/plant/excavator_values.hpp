#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/excavator_scenario.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// This file builds scenarios from the numbers of excavator.csv.

/// Returns a scenario in which the boom is held until the operator demands 4 deg/s. The scenario has a spool, a leak
/// and a drain side, in configuration a. `motion` is "scenario_a" (a step) or "scenario_b" (a ramp): the group of rows
/// that describes the motion.
ExcavatorScenario single_boom_scenario(const Parameters& parameters = Parameters::excavator(),
                                       std::string_view motion = "scenario_a");

/// Returns the simulation of two links in section 3.2 of the thesis: bucket and boom move, supplied by the same pump
/// (branch 1 of configuration a), and both valves open at once, as in section B.5.
ExcavatorScenario two_link_scenario(const Parameters& parameters = Parameters::excavator());

/// Returns a scenario in which the links `active` move in the given configuration. All valves open at once, as in
/// section B.5 of the thesis, to final areas that give each link the flow that the controller demands. REQUIRES: a link
/// is active.
ExcavatorScenario step_scenario(Configuration configuration, LinkSet active,
                                const Parameters& parameters = Parameters::excavator());

} // namespace placedpar::hydraulics
