#pragma once

#include "problems/plant/plant_record.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace placedpar {

/// The measures of how well a pole was followed. Times are in generations; an event that never happens has the greatest
/// possible time.
enum class Tracking : unsigned char {
    delay_20,         ///< from generation 200 until alpha, as a running median over 11, has covered 20 % of its change
    delay_63,         ///< until 63 %; the true alpha gets there after 40 and 126 generations of the ramp
    lag,              ///< shift in time for which the true alpha is nearest to the one found
    error_before,     ///< rms distance of the poles in generations 100 to 199,
    error_during,     ///< 200 to 399,
    error_after,      ///< and 500 to 599
    deviation_before, ///< standard deviation of alpha over time in generations 100 to 199,
    deviation_after,  ///< and 500 to 599
};
inline constexpr std::size_t tracking_figures = 8;
using TrackingFigures = std::array<double, tracking_figures>;

/// Returns the measures for the pole found in each generation of Table 5.4. REQUIRES: at least 600 generations.
TrackingFigures track(std::span<const Pole> found, const PlantChange& change);

/// The distance within which a pole counts as found.
inline constexpr double found_pole = 0.1;

} // namespace placedpar
