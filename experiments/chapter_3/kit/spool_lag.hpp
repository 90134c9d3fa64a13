#pragma once

#include "experiments/chapter_3/kit/boom_search.hpp"
#include "picture/plot.hpp"

namespace placedpar {

/// These functions compute the effect of a wrong a_0 on experiment 2.

/// Returns the a_0 with which least squares over the rising samples, areas from the voltage, gives this compliance.
/// Throws UserError if no a_0 between half the machine's own and four times as much gives it.
double lag_that_finds(double compliance_in3_per_psi, const BoomData& data);

/// Plots the compliance over the assumed a_0 for two machines, with the thesis's two compliances.
Panel panel_of_lag(std::span<const BoomData> machines);

} // namespace placedpar
