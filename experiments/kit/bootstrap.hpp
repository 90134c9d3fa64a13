#pragma once

#include "text/interval.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The least number of runs from which a 95 % interval of the median is computed. Five runs are too few: the range from
/// the least to the greatest of their values contains the true median with a probability of only 1 - 2 / 2^5, which is
/// 94 %.
constexpr std::size_t least_runs_for_interval = 6;

/// Returns the 95 % interval of the median by the bootstrap: the 2.5 and 97.5 % quantiles of the medians of 2,000
/// samples of the same size, drawn with replacement from `values`. Equal calls return equal intervals. For fewer values
/// than `least_runs_for_interval`, the interval is from minus infinity to infinity.
Interval median_interval(const std::vector<double>& values);

/// Returns the 95 % interval of sum(`above`) / sum(`below`) by the bootstrap, as median_interval() does. Both vectors
/// have one figure for each run, in the same order. REQUIRES: `above` and `below` have the same size; all figures in
/// `below` are positive.
Interval quotient_interval(const std::vector<double>& above, const std::vector<double>& below);

} // namespace placedpar
