#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/measurement.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

struct DigJob; // hydraulics/plant/dig_job.hpp

/// The moving links and the configuration of the main valve, or a job.
struct LinksInMotion {
    Configuration configuration = Configuration::a;
    LinkSet links;
    /// Not null for digging_scenario(), where links and configurations follow from the job.
    const DigJob* job = nullptr;
};

/// A motion of a simulated machine that can be recorded.
struct RecordScenario {
    std::string_view name;  ///< such as "excavator"
    std::string_view about; ///< a short description

    /// Returns the machine's constants; the scenario may replace some of them.
    Parameters (*parameters)(const Parameters& machine);
    /// Returns whether the record depends on this parameter.
    bool (*uses)(std::string_view parameter);
    /// Simulates and measures. Throws UnfitScenario (requirement.hpp) if a parameter is out of its range.
    Record (*make)(const Parameters& parameters, const LinksInMotion& moving, const UniformSource& uniform);
    /// true: the scenario can move any links in any configuration; false: it ignores `moving`
    bool any_links = false;
};

/// Returns "scenario-a" and "scenario-b" (the simple plant), "two-links" and "links" (appendix B), and "excavator" (the
/// measured machine).
std::span<const RecordScenario> record_scenarios();

/// Returns the scenario in which an excavator performs a DigJob. This scenario is not among record_scenarios(), since
/// it needs a job.
const RecordScenario& digging_scenario();

/// Returns null if there is no such scenario.
const RecordScenario* record_scenario_named(std::string_view name);

/// Returns the rows of noise.* for one of the levels none, low, mid and high; empty if there is no such level.
std::vector<Parameter> noise_rows(const Parameters& machine, std::string_view level);

} // namespace placedpar::hydraulics
