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

/// Returns the scenario with this name: a motion of a simulated excavator that can be recorded. If no scenario has the
/// name, throws a UserError that lists all scenarios.
const hydraulics::RecordScenario& scenario_called(std::string_view name);

std::vector<std::string> names_of_scenarios();

/// Returns the scenario's parameters for a machine, after applying --noise and --set. A value is a number in the
/// parameter's own unit, or a number with another unit of the same quantity: "4.1e-11 m^3/Pa". Throws UserError for an
/// unknown noise level or name, for a value that is not a number or has a unit of another quantity, and for a value
/// outside the parameter's range.
hydraulics::Parameters scenario_parameters(const hydraulics::RecordScenario& scenario,
                                           const hydraulics::Parameters& machine, const std::string& noise,
                                           const Overrides& overrides);

/// Returns the scenario's parameters as a table that --machine reads.
std::string list_parameters(const hydraulics::RecordScenario& scenario, const hydraulics::Parameters& parameters);

/// Returns one line per scenario.
std::string list_record_scenarios();

/// Simulates the scenario and returns the record of its sensors. The record's description contains the true compliance
/// and the command that makes the same record again, with every parameter that differs from the program's default. If
/// unrealistic parameters give values that no sensor could read, throws UserError with the first such value, its sensor
/// and its time.
hydraulics::Record scenario_record(const hydraulics::RecordScenario& scenario, const hydraulics::LinksInMotion& moving,
                                   const hydraulics::Parameters& parameters, std::uint64_t seed);

} // namespace placedpar
