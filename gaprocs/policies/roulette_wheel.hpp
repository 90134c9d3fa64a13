#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A wheel with one sector for each individual, by which parents are chosen at random. The sector of individual i has
/// the width max(f_i, 0), where f_i is its fitness.
class RouletteWheel {
public:
    /// Throws std::invalid_argument if the sum of all widths overflows a double.
    explicit RouletteWheel(std::span<const double> fitness);

    /// Returns whether the sum of all widths is 0, or below the smallest normal double.
    bool empty() const;
    /// Returns the individual in whose sector the ball lies. `turn` is the ball's distance from the start of the wheel,
    /// in turns (0 to 1). The ball is never in a sector of width 0. A ball at the boundary of two sectors is in the
    /// second. REQUIRES: the wheel is not empty, 0 <= turn <= 1 - 2^-32.
    std::size_t sector(double turn) const;
    /// Returns the individuals for several balls, faster than separate calls of sector(). REQUIRES: what sector()
    /// requires.
    std::vector<std::size_t> sectors(std::vector<double> turns) const;
    /// Returns the individuals for `balls` evenly spaced balls; the first ball lies at turn / balls. REQUIRES: what
    /// sector() requires.
    std::vector<std::size_t> sectors(std::size_t balls, double turn) const;

private:
    std::vector<double> ends_;
};

} // namespace placedpar
