#pragma once

#include "experiments/chapter_5/kit/counted.hpp"
#include "experiments/chapter_5/kit/plant_islands.hpp"
#include "experiments/kit/experiment.hpp"

namespace placedpar {

/// Returns the operations for one sample of a search by one island: values of the string, errors over the window, and
/// fitness. Breeding, which works on bits and random numbers, is left out.
Operations operations_of_search(const PlantIslands&);
/// Returns the operations for one sample of recursive least squares with all four delays.
Operations operations_of_recursion();

/// Judges "much less computational intensive (30 - 50 times less) than the conventional GA" (3.1), by operations, by
/// cycles of a T800 for each sample, and by operations until both have found the pole, over the seeds of the replay.
std::vector<Comparison> computation_comparisons(const ReplayContext&);

} // namespace placedpar
