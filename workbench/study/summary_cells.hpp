#pragma once

#include "workbench/study/summary.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

// A summary's cells as people read them.

/// "-" where no run has it.
std::string shown_mean(const StudyCell&);
/// "± 0.05"; "" for a single run.
std::string shown_interval(const StudyCell&);
/// "3 deadlock, 2 refused: why"; "" where all completed.
std::string ended_of(const StudyLine&);
/// "master.T_exe [ms]"; "links measured" where it is also the name of a setting.
std::string measure_with_unit(const StudySummary&, std::size_t measure);

} // namespace placedpar
