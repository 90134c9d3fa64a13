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

/// What moves in a record: links in one configuration of the main valve, or a digging job.
struct LinksInMotion {
    Configuration configuration = Configuration::a;
    LinkSet links;
    /// Null except for digging_scenario(). There the links and configurations follow from the job.
    const DigJob* job = nullptr;
};

/// A motion of a simulated machine that the command `record` can record.
struct RecordScenario {
    std::string_view name;  ///< such as "excavator"
    std::string_view about; ///< a short description

    /// Returns the machine's constants; the scenario may replace some of them.
    Parameters (*parameters)(const Parameters& machine);
    /// Returns whether the record depends on this parameter.
    bool (*uses)(std::string_view parameter);
    /// Simulates the motion, measures it, and returns the record. Throws UnfitScenario (requirement.hpp) if a parameter
    /// is out of its range.
    Record (*make)(const Parameters& parameters, const LinksInMotion& moving, const UniformSource& uniform);
    /// true: make() moves the links of `moving` in the configuration of `moving`; false: make() ignores `moving`
    bool any_links = false;
};

/// Returns "scenario-a" and "scenario-b" (a simple model of the boom), "two-links" and "links" (the model of the
/// thesis's appendix B), and "excavator" (a detailed model of the boom, measured_excavator.hpp).
std::span<const RecordScenario> record_scenarios();

/// Returns the scenario in which an excavator performs a DigJob. record_scenarios() does not contain this scenario,
/// since it needs a job.
const RecordScenario& digging_scenario();

/// Returns the scenario of record_scenarios() with this name; null if no scenario has this name.
const RecordScenario* record_scenario_named(std::string_view name);

/// Returns the parameters noise.* for one of the levels none, low, mid and high; empty if no level has this name.
std::vector<Parameter> noise_rows(const Parameters& machine, std::string_view level);

} // namespace placedpar::hydraulics
