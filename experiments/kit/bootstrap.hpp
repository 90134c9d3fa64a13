#pragma once

#include "text/interval.hpp"

#include <vector>

namespace placedpar {

/// Returns the 95 % interval of the median by the bootstrap: the 2.5 and 97.5 % quantiles of the medians of 2,000
/// samples of the same size, drawn with replacement. The same values give the same interval. REQUIRES: there is a
/// value.
Interval median_interval(const std::vector<double>& values);

/// Returns the interval of the quotient of two sums, each over one figure per run, by the bootstrap over runs as in
/// median_interval(). REQUIRES: `above` and `below` have the same size, at least 1; all figures in `below` are
/// positive.
Interval quotient_interval(const std::vector<double>& above, const std::vector<double>& below);

} // namespace placedpar
