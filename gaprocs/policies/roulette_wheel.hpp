#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A wheel with a sector as wide as max(f_i, 0) for each individual.
class RouletteWheel {
public:
    /// Throws std::invalid_argument when the sum is beyond a double.
    explicit RouletteWheel(std::span<const double> fitness);

    /// No fitness is positive, or their sum is below the smallest normal double.
    bool empty() const;
    /// The individual whose sector the ball lies in, never one without a sector. Sector i holds its lower
    /// end, not its upper. REQUIRES: not empty, 0 <= turn <= 1 - 2^-32.
    std::size_t sector(double turn) const;
    /// Of each of several balls, sooner than one after the other. REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::vector<double> turns) const;
    /// The individuals that `balls` evenly spaced balls lie with, the first at turn / balls, in order.
    /// REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::size_t balls, double turn) const;

private:
    std::vector<double> ends_;
};

} // namespace placedpar
