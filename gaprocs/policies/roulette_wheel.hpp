#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A wheel with one sector for each individual. The sector of individual i has the width max(f_i, 0).
class RouletteWheel {
public:
    /// Throws std::invalid_argument if the sum overflows a double.
    explicit RouletteWheel(std::span<const double> fitness);

    /// Returns whether the sum of all positive fitness is below the smallest normal double; also true if no fitness is
    /// positive.
    bool empty() const;
    /// Returns the individual in whose sector the ball lies. Its sector is never empty. A sector includes its lower
    /// end, not its upper end. REQUIRES: not empty, 0 <= turn <= 1 - 2^-32.
    std::size_t sector(double turn) const;
    /// Returns sector() for each of several balls, faster than one call for each ball. REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::vector<double> turns) const;
    /// Returns the individuals in whose sectors evenly spaced balls lie, in the order of the balls. There are `balls`
    /// balls, the first at turn / balls. REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::size_t balls, double turn) const;

private:
    std::vector<double> ends_;
};

} // namespace placedpar
