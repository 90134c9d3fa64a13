#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// The links that move, in a configuration of the main valve.
struct LinksInMotion {
    Configuration configuration = Configuration::a;
    LinkSet links;
};

/// A motion of a simulated machine that can be recorded.
struct RecordScenario {
    std::string_view name;  ///< "excavator"
    std::string_view about; ///< a phrase

    /// The machine's constants with those of the scenario in place of the machine's own.
    Parameters (*parameters)(const Parameters& machine);
    /// Does the record depend on this parameter?
    bool (*uses)(std::string_view parameter);
    /// Simulates and measures. Throws UnfitScenario (requirement.hpp) when a parameter is out of its range.
    Record (*make)(const Parameters& parameters, const LinksInMotion& moving, const UniformSource& uniform);
    /// Moves any links in any configuration; the other scenarios look at `parameters` only.
    bool any_links = false;
};

/// scenario-a and scenario-b of the simple plant, two-links and links of appendix B, and the measured machine,
/// excavator.
std::span<const RecordScenario> record_scenarios();

/// None when there is no such scenario.
const RecordScenario* record_scenario_named(std::string_view name);

/// The rows of noise.* for one of the levels none, low, mid and high; empty when there is no such level.
std::vector<Parameter> noise_rows(const Parameters& machine, std::string_view level);

} // namespace placedpar::hydraulics
