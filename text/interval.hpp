#pragma once

#include <cstddef>

namespace placedpar {

/// What is known of a figure from some seeds: with a probability of 95 % it lies within.
struct Interval {
    double low, high;

    bool contains(double value) const { return low <= value && value <= high; }
};

/// The interval of the probability of a success, by `successes` of `runs` (C. Clopper and E. Pearson, 1934), in
/// percent. REQUIRES: successes <= runs, runs > 0.
Interval success_interval(std::size_t successes, std::size_t runs);

/// The interval of the difference of two probabilities of success, in percent: the second minus the first, by R.
/// Newcombe's method (1998, from E. Wilson's intervals). An interval that contains 0 shows no effect.
Interval difference_interval(std::size_t first, std::size_t first_runs, std::size_t second, std::size_t second_runs);

} // namespace placedpar
