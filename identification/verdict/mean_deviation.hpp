#pragma once

#include "identification/verdict/deviation.hpp"

#include <vector>

namespace placedpar::identification {

/// Returns the mean of the deviations of several movements, each weighted by its Deviation::information(). REQUIRES: at
/// least one movement.
Deviation mean_deviation(const std::vector<Deviation>& movements);

} // namespace placedpar::identification
