#pragma once

#include <cstddef>
#include <vector>

namespace placedpar {

/// Standard deviation of a sample. REQUIRES: two values at least.
double deviation(const std::vector<double>& values);
double mean(const std::vector<double>& values);
/// How many of the values are at most `limit`, in percent.
double percent_within(const std::vector<double>& values, double limit);

} // namespace placedpar
