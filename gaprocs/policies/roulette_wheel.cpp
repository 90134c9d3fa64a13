#include "gaprocs/policies/roulette_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace placedpar {

RouletteWheel::RouletteWheel(std::span<const double> fitness) : ends_(fitness.size()) {
    double end = 0;
    for (std::size_t i = 0; i < fitness.size(); ++i)
        ends_[i] = end += fitness[i] > 0 ? fitness[i] : 0; // not a number is not above 0
    if (!std::isfinite(end))
        throw std::invalid_argument("roulette: the fitness values add up beyond a double");
}

bool RouletteWheel::empty() const { return ends_.empty() || ends_.back() < std::numeric_limits<double>::min(); }

std::size_t RouletteWheel::sector(double turn) const {
    // The first sector that ends beyond the ball is not an empty one. There is one: with turn <= 1 - 2^-32
    // the product is below the last end even when rounded.
    double ball = turn * ends_.back();
    // std::upper_bound, but without a jump at each halving: it would go either way as often.
    const double* first = ends_.data();
    for (std::size_t length = ends_.size(); length > 1;) {
        std::size_t half = length / 2;
        first += half * static_cast<std::size_t>(first[half - 1] <= ball);
        length -= half;
    }
    return static_cast<std::size_t>(first - ends_.data());
}

std::vector<std::size_t> RouletteWheel::sectors(std::size_t balls, double turn) const {
    // Rounding may put the last ball on the end of the wheel: it lies in the last sector that is not empty.
    auto last = static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), ends_.back()) - ends_.begin());
    std::vector<std::size_t> found(balls);
    std::size_t sector = 0;
    for (std::size_t i = 0; i < balls; ++i) {
        double ball = (static_cast<double>(i) + turn) / static_cast<double>(balls) * ends_.back();
        while (sector < last && ends_[sector] <= ball)
            ++sector;
        found[i] = sector;
    }
    return found;
}

} // namespace placedpar
