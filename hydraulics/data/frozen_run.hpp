#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace placedpar::hydraulics {

/// The lowest possible gauge pressure: vacuum at sea level (minus the row oil.atmospheric_pressure).
inline constexpr double vacuum_psi = -14.7;

/// A run of samples in which a sensor repeats one reading. After the run the reading jumps to the true value.
struct FrozenRun {
    std::size_t first, last; ///< the samples are [first, last)
    double jump;             ///< step at the end of the run
};

/// We chose these limits. A run has at least five equal readings and lasts at least 0.1 s, because the reading of a
/// changing pressure or of a moving joint changes sooner. The jump is at least 40 psi, or half a degree. The jump is
/// also greater than the step after it. This condition excludes a link that starts from rest: the link gathers speed,
/// so its first step is smaller than the next.
std::size_t fewest_frozen(double period_s);
inline constexpr double least_jump_psi = 40, least_jump_deg = 0.5;

/// Returns the first frozen run. `fewest` is the least number of equal readings, from fewest_frozen().
std::optional<FrozenRun> frozen_run(std::span<const double> readings, double least_jump, std::size_t fewest);

} // namespace placedpar::hydraulics
