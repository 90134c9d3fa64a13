#pragma once

#include "experiments/chapter_3/kit/boom_search.hpp"
#include "picture/plot.hpp"

namespace placedpar {

/// These functions compute how a wrong a_0, the rate at which the valve's spool follows the voltage (equation A.2),
/// affects experiment 2 of chapter 3.

/// Returns the a_0 with which a least-squares fit gives this compliance. The fit uses the samples in which the pressure
/// rises, with the spool computed from the voltage. Throws UserError if no a_0 from .75 to 4 times the machine's own
/// a_0 gives this compliance.
double lag_that_finds(double compliance_in3_per_psi, const BoomData& data);

/// Plots the compliance against the assumed a_0 for each machine, and marks the two compliances that the thesis found.
Panel panel_of_lag(std::span<const BoomData> machines);

} // namespace placedpar
