#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace placedpar::hydraulics {

/// The lowest gauge pressure, at which nothing is left of the atmospheric pressure at sea level (the row
/// oil.atmospheric_pressure).
inline constexpr double vacuum_psi = -14.7;

/// Samples in which a sensor repeats a single reading. After them the reading jumps to the true value.
struct FrozenRun {
    std::size_t first, last; ///< `last` is one past the end
    double jump;             ///< step at the end of the run
};

/// These limits are all ours. A run has at least five equal readings and lasts at least 0.1 s: a pressure or a joint
/// that moves passes a converter's code in less time. The jump is at least 40 psi, or half a degree. It is also greater
/// than the step after the jump, because a body at rest starts slowly and gathers speed.
std::size_t fewest_frozen(double period_s);
inline constexpr double least_jump_psi = 40, least_jump_deg = 0.5;

/// Returns the first frozen run. `fewest` is the number of equal readings, from fewest_frozen().
std::optional<FrozenRun> frozen_run(std::span<const double> readings, double least_jump, std::size_t fewest);

} // namespace placedpar::hydraulics
