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
        ends_[i] = end += fitness[i] > 0 ? fitness[i] : 0; // NaN counts as 0
    if (!std::isfinite(end))
        throw std::invalid_argument("roulette: the sum of the fitness values is beyond the range of a double");
}

bool RouletteWheel::empty() const { return ends_.empty() || ends_.back() < std::numeric_limits<double>::min(); }

std::size_t RouletteWheel::sector(double turn) const { return sectors({turn}).front(); }

std::vector<std::size_t> RouletteWheel::sectors(std::vector<double> balls) const {
    // A ball is in the first sector that ends beyond it, so never in a sector of width 0. The last sector ends beyond
    // every ball: a ball is at most 1 - 2^-32 turns from the start, so its distance in turns, multiplied by the end of
    // the last sector, is below that end, even when rounded.
    for (double& ball : balls)
        ball *= ends_.back();
    // This is std::upper_bound for all balls at once. The halving steps for a single ball depend on each other, so the
    // processor would wait for each step. The loop has no branch, because a processor would mispredict the branch half
    // of the time.
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
    // The index of a ball's sector is the number of sector ends at or below the ball. The loop counts these ends
    // without a branch, which a processor would mispredict half of the time. Rounding may put the last ball at the end
    // of the wheel. That end is not counted, so the ball is in the last sector that is not empty.
    const double all = static_cast<double>(balls), end = ends_.back(), turns = 1 / end;
    constexpr std::size_t past = 3;
    std::vector<double> places(balls + past, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < balls; ++i)
        places[i] = (static_cast<double>(i) + turn) / all * end;
    std::vector<std::size_t> found(balls + past);
    for (double sector_end : ends_) {
        if (sector_end == end)
            break;
        // Even with rounding, the number of balls before this end is between `before` and `before` + 3.
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
