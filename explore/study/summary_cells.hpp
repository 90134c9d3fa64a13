#pragma once

#include "explore/study/summary.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

// These functions return the cells of a study's summary as text for readers.

/// Returns the mean; "-" if no run has the measure.
std::string shown_mean(const StudyCell&);
/// Returns the confidence interval of the mean as "± 0.05"; "" for a single run.
std::string shown_interval(const StudyCell&);
/// Returns how the runs of a line ended, and how many measured no number, such as "3 deadlock, 2 refused: why" or
/// "5 without island.best"; "" if all completed with all figures.
std::string ended_of(const StudyLine&);
/// Returns the heading of a measure, such as "master.T_exe [ms]"; "relative master.T_exe" if there are reference runs.
/// If a setting has the name of the measure, "measured" follows the name: "links measured".
std::string measure_with_unit(const StudySummary&, std::size_t measure);
/// Returns whether some combination was run with several seeds.
bool has_intervals(const StudySummary&);
/// Returns the line's value of an axis as "slaves = 2", or "slaves not set" if only other lines set it.
std::string shown_setting(const StudySummary&, const StudyLine&, std::size_t axis);
/// Returns the value alone: "2", or "not set".
std::string shown_value(const StudyLine&, std::size_t axis);
/// Returns the settings as "slaves = 2, clock = 5M".
std::string shown_settings(const Overrides&);
/// Returns the message for reference settings (Study::relative_to) that no run has. `set`: the names of the settings
/// that the runs have.
std::string there_is_no_reference(const Overrides& wanted, const std::vector<std::string>& set);
/// Returns sentences that hold for all lines: "all with samples = 12", "relative to slaves = 0".
std::vector<std::string> said_of_all(const StudySummary&);

} // namespace placedpar
