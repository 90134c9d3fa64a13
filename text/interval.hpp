#pragma once

#include <cstddef>

namespace placedpar {

/// A confidence interval of 95 % for a value that is estimated from several runs with different random seeds.
struct Interval {
    double low, high;

    bool contains(double value) const { return low <= value && value <= high; }
};

/// Returns the interval, in percent, of the probability that a run succeeds, if `successes` of `runs` succeeded (C.
/// Clopper and E. Pearson, 1934). REQUIRES: successes <= runs, runs > 0.
Interval success_interval(std::size_t successes, std::size_t runs);

/// Returns the interval, in percentage points, of the probability of success of the second group of runs minus that of
/// the first group. `first` and `second` are the numbers of successes. The method is R. Newcombe's (1998), based on E.
/// Wilson's intervals. If the interval contains 0, the data show no difference.
Interval difference_interval(std::size_t first, std::size_t first_runs, std::size_t second, std::size_t second_runs);

} // namespace placedpar
