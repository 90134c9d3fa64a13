#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Of the median, by the bootstrap: 2,000 samples of as many values, drawn with replacement; their 2.5 and 97.5 %
/// quantiles. The same values give the same interval. REQUIRES: not empty.
Interval median_interval(const std::vector<double>& values);

/// Of the quotient of what two figures of each run are in sum, by the bootstrap over runs as median_interval().
/// REQUIRES: as many figures of both, at least one; those below positive.
Interval quotient_interval(const std::vector<double>& above, const std::vector<double>& below);

/// Of the probability of a success, by `successes` of `runs` (C. Clopper and E. Pearson, 1934), in percent. REQUIRES:
/// successes <= runs, runs > 0.
Interval success_interval(std::size_t successes, std::size_t runs);

/// Of the difference of two probabilities of success, in percent: the second minus the first, by R. Newcombe's method
/// (1998, from E. Wilson's intervals). An interval that contains 0 shows no effect.
Interval difference_interval(std::size_t first, std::size_t first_runs, std::size_t second, std::size_t second_runs);

} // namespace placedpar
