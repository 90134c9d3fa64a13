#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace placedpar::hydraulics {

/// A gauge that reads less has no pressure to read: at sea level (the row oil.atmospheric_pressure) nothing is left.
inline constexpr double vacuum_psi = -14.7;

/// Samples in which a sensor repeats one reading, and after which it jumps to where what it reads has gone meanwhile.
struct FrozenRun {
    std::size_t first, last; ///< past the end
    double jump;             ///< at its end
};

/// All ours: equal readings for a tenth of a second, at least five, for a pressure or a joint that moves passes a
/// converter's code in less; a jump of 40 psi, or of half a degree, that is greater than the step after it, for what
/// has rested begins to move slowly and gathers speed.
std::size_t fewest_frozen(double period_s);
inline constexpr double least_jump_psi = 40, least_jump_deg = 0.5;

/// The first of them. `fewest`: equal readings, by fewest_frozen().
std::optional<FrozenRun> frozen_run(std::span<const double> readings, double least_jump, std::size_t fewest);

} // namespace placedpar::hydraulics
