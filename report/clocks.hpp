#pragma once

#include "netlist/run_report.hpp"
#include "report/field.hpp"

#include <vector>

namespace placedpar {

/// Returns a table of the clocks of ranks, the processes of mpirun: how far each clock drifted from the clock of rank 0
/// during the run, and the greatest possible error of a comparison of the two clocks.
Table clocks_of(const std::vector<RankClock>&);

} // namespace placedpar
