#pragma once

#include <vector>

namespace placedpar {

/// Returns the standard deviation of a sample. REQUIRES: at least two values.
double deviation(const std::vector<double>& values);
double mean(const std::vector<double>& values);
/// Returns the share of the values that are at most `limit`, in percent.
double percent_within(const std::vector<double>& values, double limit);

/// Returns the median as Boost.Math computes it: the middle value, or the mean of the middle two. REQUIRES: at least
/// one value.
double median(std::vector<double> values);

/// Returns the middle value, or the lower of the two middle values. Tables of search results use this median, because
/// it is a value that a search has found, and not a mean of two. REQUIRES: at least one value.
double lower_median(std::vector<double> values);

/// Returns the quantile by nearest rank: the value with number ceil(share * size) in ascending order, counted from 1.
/// Returns the least value if the share is 0. REQUIRES: at least one value, 0 <= share <= 1.
double quantile(std::vector<double> values, double share);

} // namespace placedpar
