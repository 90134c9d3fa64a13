#pragma once

#include "experiments/chapter_3/kit/boom_search.hpp"
#include "picture/plot.hpp"

namespace placedpar {

/// These functions compute the effect of a wrong a_0 on experiment 2.

/// Returns the a_0 with which least squares from the voltage gives this compliance, while the pressure rises. Throws
/// UserError if no a_0 from .75 to 4 times the machine's own does.
double lag_that_finds(double compliance_in3_per_psi, const BoomData& data);

/// Plots the compliance over the assumed a_0 for each machine, with the thesis's two compliances.
Panel panel_of_lag(std::span<const BoomData> machines);

} // namespace placedpar
