#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A wheel with a sector as wide as max(f_i, 0) for each individual.
class RouletteWheel {
public:
    /// Throws std::invalid_argument if the sum overflows a double.
    explicit RouletteWheel(std::span<const double> fitness);

    /// Returns whether no fitness is positive, or their sum is below the smallest normal double.
    bool empty() const;
    /// Returns the individual in whose sector the ball lies, never one with an empty sector. A sector includes its
    /// lower end, not its upper. REQUIRES: not empty, 0 <= turn <= 1 - 2^-32.
    std::size_t sector(double turn) const;
    /// Returns sector() for each of several balls, faster than one by one. REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::vector<double> turns) const;
    /// Returns the individuals in whose sectors `balls` evenly spaced balls lie, the first at turn / balls, in order.
    /// REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::size_t balls, double turn) const;

private:
    std::vector<double> ends_;
};

} // namespace placedpar
