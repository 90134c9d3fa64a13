#pragma once

#include "experiments/chapter_3/kit/two_link_study.hpp"
#include "picture/plot.hpp"

namespace placedpar {

/// Draws Figure 3.9: all states of the simulated circuit over time.
Plot plot_of_states(const TwoLinkMotion& motion);

/// Draws Figure 3.10: the internal pressures and flows over time, as computed from the best individuals and as
/// simulated.
Plot plot_of_estimated_states(const TwoLinkMotion& motion, const identification::ComplianceSearch& prepared,
                              const identification::SearchRun& run);

/// Draws Figure 3.11: the compliances over the generations, estimated by two searches. `gated` omits samples in which
/// the motion does not excite the compliances (identification/excitation_gate.hpp); `plain` does not. A third panel has
/// the slopes of the pressures at the samples of `plain`.
Plot plot_of_compliances(const identification::ComplianceSearch& prepared, const identification::SearchRun& plain,
                         const identification::SearchRun& gated, std::size_t trials);

} // namespace placedpar
