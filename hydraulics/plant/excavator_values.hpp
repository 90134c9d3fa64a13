#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/excavator_scenario.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// These functions make scenarios for the simulation from the machine's constants.

/// Returns a scenario in which the boom is held until the operator demands 4 deg/s, in configuration a. The boom has a
/// spool, a leak and a drain side. `motion` is "scenario_a" (the spool's command is a step) or "scenario_b" (a ramp),
/// the first part of the names of the parameters that describe the motion.
ExcavatorScenario single_boom_scenario(const Parameters& parameters = Parameters::excavator(),
                                       std::string_view motion = "scenario_a");

/// Returns the scenario of section 3.2 of the thesis. One pump moves the bucket and the boom (branch 1 of configuration
/// a). Both valves open at the same time, as in section B.5.
ExcavatorScenario two_link_scenario(const Parameters& parameters = Parameters::excavator());

/// Returns a scenario in which the links `active` move in the given configuration. All valves open at the same time, as
/// in section B.5 of the thesis. Their final areas give each link the flow that the controller demands. REQUIRES: a
/// link is active.
ExcavatorScenario step_scenario(Configuration configuration, LinkSet active,
                                const Parameters& parameters = Parameters::excavator());

} // namespace placedpar::hydraulics
