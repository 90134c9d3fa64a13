#include "gaprocs/policies/roulette_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

std::size_t RouletteWheel::sector(double turn) const { return sectors({turn}).front(); }

std::vector<std::size_t> RouletteWheel::sectors(std::vector<double> balls) const {
    // The first sector that ends beyond the ball is not an empty one. There is one: with turn <= 1 - 2^-32
    // the product is below the last end even when rounded.
    for (double& ball : balls)
        ball *= ends_.back();
    // std::upper_bound, but of all balls by turns, since each halving of one waits for the one before; and without a
    // jump, which would go either way as often.
    std::vector<std::size_t> found(balls.size());
    for (std::size_t length = ends_.size(); length > 1;) {
        const std::size_t half = length / 2;
        for (std::size_t i = 0; i < balls.size(); ++i)
            found[i] += half * static_cast<std::size_t>(ends_[found[i] + half - 1] <= balls[i]);
        length -= half;
    }
    return found;
}

std::vector<std::size_t> RouletteWheel::sectors(std::size_t balls, double turn) const {
    // A ball lies in the sector whose number is that of the ends up to the ball: so many, for every ball, without a
    // jump that would go either way as often. Rounding may put the last ball on the end of the wheel: it lies in the
    // last sector that is not empty, whose end is not counted.
    const double all = static_cast<double>(balls), end = ends_.back(), turns = 1 / end;
    constexpr std::size_t past = 3;
    std::vector<double> places(balls + past, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < balls; ++i)
        places[i] = (static_cast<double>(i) + turn) / all * end;
    std::vector<std::size_t> found(balls + past);
    for (double sector_end : ends_) {
        if (sector_end == end)
            break;
        // The balls before this end: two or one more than `before`, or by rounding three or none.
        auto before = static_cast<std::ptrdiff_t>(std::max(sector_end * turns * all - turn, 1.0)) - 1;
        const double* place = places.data() + before;
        before += (place[0] < sector_end) + (place[1] < sector_end) + (place[2] < sector_end);
        ++found[static_cast<std::size_t>(before)];
    }
    found.resize(balls);
    std::partial_sum(found.begin(), found.end(), found.begin());
    return found;
}

} // namespace placedpar
