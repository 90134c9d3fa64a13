#pragma once

#include <vector>

namespace placedpar {

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
