#pragma once

#include "netlist/run_report.hpp"
#include "report/field.hpp"

#include <vector>

namespace placedpar {

/// Returns a table of how well the clocks of ranks are known.
Table clocks_of(const std::vector<RankClock>&);

} // namespace placedpar
