#pragma once

#include <cstddef>
#include <vector>

namespace placedpar {

/// The value that the given share of the sample does not exceed. REQUIRES: not empty.
double share_below(std::vector<double> values, double share);
double median(std::vector<double> values);
/// Standard deviation of a sample. REQUIRES: two values at least.
double deviation(const std::vector<double>& values);
double mean(const std::vector<double>& values);
/// How many of the values are at most `limit`, in percent.
double percent_within(const std::vector<double>& values, double limit);

} // namespace placedpar
