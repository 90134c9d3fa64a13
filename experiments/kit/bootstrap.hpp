#pragma once

#include "text/interval.hpp"

#include <vector>

namespace placedpar {

/// Returns the 95 % interval of the median by the bootstrap: the 2.5 and 97.5 % quantiles of the medians of 2,000
/// samples of the same size, drawn with replacement from `values`. Equal calls return equal intervals. REQUIRES:
/// `values` is not empty.
Interval median_interval(const std::vector<double>& values);

/// Returns the 95 % interval of sum(`above`) / sum(`below`) by the bootstrap, as median_interval() does. Both vectors
/// have one figure for each run, in the same order. REQUIRES: `above` and `below` have the same size, at least 1; all
/// figures in `below` are positive.
Interval quotient_interval(const std::vector<double>& above, const std::vector<double>& below);

} // namespace placedpar
