#pragma once

#include "experiments/kit/experiment.hpp"
#include "experiments/kit/record_seeds.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// The results of one run of an experiment, in an order that the experiment defines.
using Figures = std::vector<double>;

/// Returns the seeds with which the experiment is run; their number is ReplayContext::seeds.
Seeds seeds_of(const ReplayContext& context);

/// Calls `run` with each seed of seeds_of(), using all cores. Returns the figures in the order of the seeds. Progress
/// is reported as "WHAT: 12 of 60 seeds", where WHAT is `what`. Runs in ReplayContext::results are not repeated; new
/// runs are added to these results. REQUIRES: `run` may be called from several threads at once; `what` is unique within
/// the experiment. If ReplayContext::progress or a run throws, the exception is passed on after the current runs have
/// ended. Throws UnfinishedRun if interrupted.
std::vector<Figures> run_seeds(const ReplayContext& context, const std::string& what,
                               const std::function<Figures(std::uint64_t seed)>& run);

/// Returns the figure at `index` of every run.
std::vector<double> column(const std::vector<Figures>& runs, std::size_t index);
/// Returns the lower_median() of the figure at `index`. REQUIRES: at least one run.
double lower_median_of(const std::vector<Figures>& runs, std::size_t index);

} // namespace placedpar
