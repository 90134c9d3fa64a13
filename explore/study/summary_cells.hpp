#pragma once

#include "explore/study/summary.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

// A summary's cells as people read them.

/// "-" where no run has it.
std::string shown_mean(const StudyCell&);
/// "± 0.05"; "" for a single run.
std::string shown_interval(const StudyCell&);
/// "3 deadlock, 2 refused: why"; "" where all completed.
std::string ended_of(const StudyLine&);
/// "master.T_exe [ms]"; "links measured" where it is also the name of a setting; "relative master.T_exe".
std::string measure_with_unit(const StudySummary&, std::size_t measure);
/// Whether some combination was run with several seeds.
bool has_intervals(const StudySummary&);
/// "slaves = 2, clock = 5M".
std::string shown_settings(const Overrides&);
/// What is wrong with settings that no run has, where figures are to be relative to those with them: a sentence, with
/// the names of what runs set.
std::string there_is_no_reference(const Overrides& wanted, const std::vector<std::string>& set);
/// What holds for all lines: "all with samples = 12", "relative to slaves = 0".
std::vector<std::string> said_of_all(const StudySummary&);

} // namespace placedpar
