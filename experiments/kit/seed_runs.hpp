#pragma once

#include "experiments/kit/experiment.hpp"
#include "experiments/kit/record_seeds.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// What one run of an experiment gave, in an order that the experiment knows.
using Figures = std::vector<double>;

/// The seeds of this replay: as many as the experiment says, or --seeds.
Seeds seeds_of(const ReplayContext& context);

/// A run for each of those seeds, on all processors, as a study of a function; the figures come in the order of the
/// seeds. Progress is told as "what: 12 of 60 seeds". Runs that ReplayContext::results has are not made again, those
/// that are made are added to it. REQUIRES: `run` may be called from several threads at once; no other runs of the
/// experiment are called `what`. Throws what progress or a run throws, after the runs under
/// way have ended, and UnfinishedRun.
std::vector<Figures> run_seeds(const ReplayContext& context, const std::string& what,
                               const std::function<Figures(std::uint64_t seed)>& run);

/// Number `index` of every run's figures.
std::vector<double> column(const std::vector<Figures>& runs, std::size_t index);

} // namespace placedpar
