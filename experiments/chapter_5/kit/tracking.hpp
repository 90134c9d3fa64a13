#pragma once

#include "problems/plant/plant_record.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace placedpar {

/// These measures state how well a search followed the pole alpha + j beta of a plant that changes from generation 200
/// to 400. Delays are in generations. If an event never happens, its delay is the greatest possible delay.
enum class Tracking : unsigned char {
    delay_20, ///< delay from generation 200 until the running median of alpha over 11 generations has covered 20 % of
              ///< the change; the true alpha has a delay of 40 generations
    delay_63, ///< as `delay_20`, but for 63 % of the change; the true alpha has a delay of 126 generations
    lag,      ///< delay by which the true alpha must be shifted to be nearest to the found alpha
    error_before,     ///< rms distance between found and true pole in generations 100 to 199
    error_during,     ///< rms distance in generations 200 to 399
    error_after,      ///< rms distance in generations 500 to 599
    deviation_before, ///< standard deviation of alpha over time in generations 100 to 199
    deviation_after,  ///< standard deviation in generations 500 to 599
};
inline constexpr std::size_t tracking_figures = 8;
using TrackingFigures = std::array<double, tracking_figures>;

/// Returns the measures. `found` has the pole that was found in each generation of the change in Table 5.4. REQUIRES:
/// at least 600 generations.
TrackingFigures track(std::span<const Pole> found, const PlantChange& change);

/// The distance within which a pole counts as found.
inline constexpr double found_pole = 0.1;

} // namespace placedpar
