#pragma once

#include <vector>

namespace placedpar::identification {

/// Half of the values lie on either side of it: the middle one, or the mean of the middle two (Boost.Math's).
/// REQUIRES: not empty.
double median(std::vector<double> values);

/// The smallest of the values such that at least the given share of them lie at or below it: number ceil(share * size)
/// in ascending order (nearest rank). Always one of the values: at one half it is the lower of two middle ones, where
/// median() is their mean. REQUIRES: not empty, 0 <= share <= 1.
double quantile(std::vector<double> values, double share);

} // namespace placedpar::identification
