#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace placedpar::hydraulics {

/// A gauge that reads less has no pressure to read: at sea level (the row oil.atmospheric_pressure) nothing is left.
inline constexpr double vacuum_psi = -14.7;

/// Samples in which a sensor repeats one reading, and after which it jumps to where the pressure has gone meanwhile.
struct FrozenRun {
    std::size_t first, last; ///< past the end
    double jump_psi;         ///< at its end
};

/// The first of them. All ours: five equal readings, for a pressure that moves passes a converter's code in less; a
/// jump of 40 psi that is greater than the step after it, for one that has rested begins to move slowly and gathers
/// speed.
std::optional<FrozenRun> frozen_run(std::span<const double> psi, std::size_t fewest = 5, double least_jump_psi = 40);

} // namespace placedpar::hydraulics
