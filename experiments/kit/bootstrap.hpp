#pragma once

#include "text/interval.hpp"

#include <vector>

namespace placedpar {

/// The interval of the median, by the bootstrap: 2,000 samples of as many values, drawn with replacement; their 2.5
/// and 97.5 % quantiles. The same values give the same interval. REQUIRES: not empty.
Interval median_interval(const std::vector<double>& values);

/// The interval of the quotient of what two figures of each run are in sum, by the bootstrap over runs as
/// median_interval(). REQUIRES: as many figures of both, at least one; those below positive.
Interval quotient_interval(const std::vector<double>& above, const std::vector<double>& below);

} // namespace placedpar
