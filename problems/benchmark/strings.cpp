#include "problems/benchmark/strings.hpp"

#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace placedpar {

double OneMax::objective(const Genome& genome) const {
    int ones = 0;
    for (std::uint64_t word : genome.words())
        ones += std::popcount(word);
    return ones;
}

double Trap::objective(const Genome& genome) const {
    std::size_t sum = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        auto ones = static_cast<std::size_t>(std::popcount(genome.field(block * size, size)));
        sum += ones == size ? size : size - 1 - ones;
    }
    return static_cast<double>(sum);
}

Landscape::Landscape(std::size_t bits, std::size_t k, std::vector<double> contributions)
    : bits_(bits), k_(k), contributions_(std::move(contributions)) {}

double Landscape::objective(const Genome& genome) const {
    double sum = 0;
    std::size_t mask = (std::size_t{1} << (k_ + 1)) - 1, neighbourhood = 0;
    for (std::size_t i = 0; i < bits_ + k_; ++i) {
        neighbourhood = (neighbourhood << 1 | genome.bit(i % bits_)) & mask;
        if (i >= k_)
            sum += contribution(i - k_, neighbourhood);
    }
    return sum;
}

/// Returns the best sum of all strings whose first k bits are `first`. Extends the strings bit by bit. Keeps the best
/// sum for each value of the last k bits, because only these bits affect later contributions.
double Landscape::best_from(std::size_t first) const {
    std::size_t states = std::size_t{1} << k_;
    constexpr double never = -std::numeric_limits<double>::infinity();
    std::vector<double> best(states, never), next;
    best[first] = 0;
    for (std::size_t i = k_; i < bits_ + k_; ++i) {
        next.assign(states, never);
        for (std::size_t state = 0; state < states; ++state)
            for (std::size_t bit : {0u, 1u}) {
                bool free = i < bits_;
                if (!free && bit != (first >> (bits_ + k_ - 1 - i) & 1))
                    continue;
                std::size_t neighbourhood = state << 1 | bit;
                double& reached = next[neighbourhood & (states - 1)];
                reached = std::max(reached, best[state] + contribution(i - k_, neighbourhood));
            }
        std::swap(best, next);
    }
    return best[first];
}

std::optional<double> Landscape::optimum() const {
    constexpr std::size_t most_steps = std::size_t{1} << 24;
    if (bits_ << (2 * k_) > most_steps)
        return std::nullopt;
    double best = 0;
    for (std::size_t first = 0; first < std::size_t{1} << k_; ++first)
        best = std::max(best, best_from(first));
    return best;
}

Landscape NkLandscape::problem() const {
    if (k >= bits)
        throw UserError(fmt::format("k = {}, but bits = {}: a bit can have at most {} of the other bits as neighbours",
                                    k, bits, bits - 1));
    RandomStream random(seed, "contributions of an NK landscape");
    std::vector<double> contributions(bits << (k + 1));
    for (double& each : contributions)
        each = random.uniform() / static_cast<double>(bits);
    return {bits, k, std::move(contributions)};
}

} // namespace placedpar
