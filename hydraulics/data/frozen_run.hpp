#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace placedpar::hydraulics {

/// The lowest possible gauge pressure: vacuum at sea level (minus the parameter oil.atmospheric_pressure).
inline constexpr double vacuum_psi = -14.7;

/// A run of samples in which a faulty sensor repeats one reading. After the run the reading jumps to the true value.
struct FrozenRun {
    std::size_t first, last; ///< indices of the samples, [first, last)
    double jump;             ///< step at the end of the run
};

/// Returns the least number of equal readings in a frozen run: five, and as many as last 0.1 s. The reading of a
/// changing pressure or a moving joint changes sooner. The limits in this file are this project's choice.
std::size_t fewest_frozen(double period_s);
inline constexpr double least_jump_psi = 40, least_jump_deg = 0.5;

/// Returns the first run of at least `fewest` equal readings (fewest_frozen()) that ends with a jump of at least
/// `least_jump`. The jump must also be greater than the step after it. A link that starts from rest is therefore not a
/// frozen run: it gathers speed, so its first step is smaller than its second.
std::optional<FrozenRun> frozen_run(std::span<const double> readings, double least_jump, std::size_t fewest);

} // namespace placedpar::hydraulics
