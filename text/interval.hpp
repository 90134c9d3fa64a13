#pragma once

#include <cstddef>

namespace placedpar {

/// A confidence interval of 95 % for a value that was estimated from runs with different seeds.
struct Interval {
    double low, high;

    bool contains(double value) const { return low <= value && value <= high; }
};

/// Returns the interval, in percent, of the probability of a success, given `successes` in `runs` (C. Clopper and E.
/// Pearson, 1934). REQUIRES: successes <= runs, runs > 0.
Interval success_interval(std::size_t successes, std::size_t runs);

/// Returns the interval, in percent, of the difference of two probabilities of success, the second minus the first. The
/// method is R. Newcombe's (1998), based on E. Wilson's intervals. An interval that contains 0 shows no effect.
Interval difference_interval(std::size_t first, std::size_t first_runs, std::size_t second, std::size_t second_runs);

} // namespace placedpar
