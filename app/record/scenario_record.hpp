#pragma once

#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "netlist/read.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// The scenario of that name. Throws UserError that lists those there are.
const hydraulics::RecordScenario& scenario_called(std::string_view name);

std::vector<std::string> names_of_scenarios();

/// The scenario's parameters on a machine, with those that --noise and --set gave in place of its own. A value is a
/// number in the room's unit, or one with a unit: "4.1e-11 m^3/Pa". Throws UserError for a level of noise or
/// a name that the scenario does not know, for what is not a number or no unit of the quantity, and for a value out of
/// the parameter's range.
hydraulics::Parameters scenario_parameters(const hydraulics::RecordScenario& scenario,
                                           const hydraulics::Parameters& machine, const std::string& noise,
                                           const Overrides& overrides);

/// The scenario's parameters as a table that --machine reads.
std::string list_parameters(const hydraulics::RecordScenario& scenario, const hydraulics::Parameters& parameters);

/// A line a scenario.
std::string list_record_scenarios();

/// The record, whose description says how to make it again: the command, with every parameter that is not the
/// program's own, and the true compliance. Throws UserError, naming the first instant and channel, where
/// parameters far from any machine's make a record that no sensor could have read.
hydraulics::Record scenario_record(const hydraulics::RecordScenario& scenario, const hydraulics::LinksInMotion& moving,
                                   const hydraulics::Parameters& parameters, std::uint64_t seed);

} // namespace placedpar
