#pragma once

#include "problems/plant/plant_record.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace placedpar {

/// How well a pole was followed. Times are in generations; what never happens has the greatest time there is.
enum class Tracking : unsigned char {
    delay_20,         ///< from generation 200 until alpha has covered 20 % of its way, by its running median over 11
    delay_63,         ///< until 63 %; the truth itself is there after 40 and 126 generations of the ramp
    lag,              ///< the shift of the true alpha over time that comes nearest to the one found
    error_before,     ///< root of the mean squared distance of the poles in generations 100 to 199,
    error_during,     ///< 200 to 399,
    error_after,      ///< and 500 to 599
    deviation_before, ///< standard deviation of alpha in time over generations 100 to 199,
    deviation_after,  ///< and 500 to 599
};
inline constexpr std::size_t tracking_figures = 8;
using TrackingFigures = std::array<double, tracking_figures>;

/// Of the pole that was found in each generation of Table 5.4. REQUIRES: 600 generations or more.
TrackingFigures track(std::span<const Pole> found, const PlantChange& change);

/// A pole nearer than this was found.
inline constexpr double found_pole = 0.1;

} // namespace placedpar
