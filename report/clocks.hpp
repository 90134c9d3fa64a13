#pragma once

#include "netlist/run_report.hpp"
#include "report/field.hpp"

#include <vector>

namespace placedpar {

/// Returns a table with the drift of each rank's clock, and the greatest error with which the clock was compared.
Table clocks_of(const std::vector<RankClock>&);

} // namespace placedpar
