#pragma once

#include <vector>

namespace placedpar {

/// Standard deviation of a sample. REQUIRES: two values at least.
double deviation(const std::vector<double>& values);
double mean(const std::vector<double>& values);
/// Returns the share of the values that are at most `limit`, in percent.
double percent_within(const std::vector<double>& values, double limit);

/// Half of the values lie on either side of it: the middle one, or the mean of the middle two (Boost.Math's).
/// REQUIRES: not empty.
double median(std::vector<double> values);

/// The middle one, and of two middle ones the lower: quantile(values, 0.5). Where a table gives the median of what many
/// searches found, it is one that was found, and not the mean of two. REQUIRES: not empty.
double lower_median(std::vector<double> values);

/// The smallest of the values such that at least the given share of them lie at or below it: number ceil(share * size)
/// in ascending order (nearest rank). Always one of the values. REQUIRES: not empty, 0 <= share <= 1.
double quantile(std::vector<double> values, double share);

} // namespace placedpar
