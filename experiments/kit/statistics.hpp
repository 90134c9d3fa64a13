#pragma once

#include <cstddef>
#include <vector>

namespace placedpar {

/// Standard deviation of a sample. REQUIRES: two values at least.
double deviation(const std::vector<double>& values);
double mean(const std::vector<double>& values);
/// How many of the values are at most `limit`, in percent.
double percent_within(const std::vector<double>& values, double limit);

/// A median, and where it lies with 95 % of probability.
struct Interval {
    double median, low, high;
};
/// By the bootstrap: the middle 95 % of the medians of 2000 samples of the same size, drawn from the values with
/// replacement. The same values give the same interval. REQUIRES: not empty.
Interval median_interval(const std::vector<double>& values);

} // namespace placedpar
