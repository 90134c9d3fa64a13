#pragma once

#include "experiments/chapter_3/kit/boom_search.hpp"
#include "picture/plot.hpp"

namespace placedpar {

/// What experiment 2 finds when the a_0 that it believes in is not the machine's, and experiment 1 when the spool
/// reads too low.

/// The a_0 with which least squares over the rising samples, areas from the voltage, finds a compliance.
/// Throws UserError when none between half and four times the machine's does.
double lag_that_finds(double compliance_in3_per_psi, const BoomData& data);

/// The offset of the spool, below 0, that left in its readings makes least squares over the rising samples find a
/// compliance. Throws UserError when none down to -.015 in does.
double offset_that_finds(double compliance_in3_per_psi, const BoomData& data);

/// The compliance found over the a_0 believed in, for two machines, with the thesis's two compliances.
Panel panel_of_lag(std::span<const BoomData> machines);

} // namespace placedpar
