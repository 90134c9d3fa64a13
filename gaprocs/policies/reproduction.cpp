#include "gaprocs/policies/reproduction.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace placedpar {

namespace {

/// Chooses `count` parents by one spin of the roulette wheel with `count` equally spaced balls. Then shuffles the
/// parents (Fisher and Yates).
Parents sample_universally(const RouletteWheel& wheel, std::size_t count, RandomStream& random) {
    std::vector<std::size_t> parents = wheel.sectors(count, random.uniform());
    for (std::size_t left = parents.size(); left > 1; --left)
        std::swap(parents[left - 1], parents[random.below(static_cast<std::uint32_t>(left))]);
    return parents;
}

/// Returns the average number of copies of each individual. This number is a linear function of the fitness, with the
/// value 1 at the mean fitness.
std::vector<double> scaled_copies(std::span<const double> fitness, double best) {
    auto [least, greatest] = std::minmax_element(fitness.begin(), fitness.end());
    std::vector<double> copies(fitness.size(), 1);
    if (*least == *greatest)
        return copies;
    // Fitness values are halved, because the difference of two large doubles could overflow.
    double mean = 0;
    for (double each : fitness)
        mean += each / 2 / static_cast<double>(fitness.size());
    double above = *greatest / 2 - mean, below = mean - *least / 2;
    double slope = std::min((best - 1) / above, 1 / below);
    for (std::size_t i = 0; i < fitness.size(); ++i)
        copies[i] = std::max(1 + slope * (fitness[i] / 2 - mean), 0.0);
    return copies;
}

/// Returns the rank of each individual, 0 for the worst. Individuals of equal fitness share the mean of their ranks.
std::vector<double> ranks_of(std::span<const double> fitness) {
    std::vector<std::size_t> order(fitness.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return fitness[a] != fitness[b] ? fitness[a] < fitness[b] : a < b; });
    std::vector<double> ranks(fitness.size());
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
        while (end < order.size() && fitness[order[end]] == fitness[order[first]])
            ++end;
        for (std::size_t i = first; i < end; ++i)
            ranks[order[i]] = static_cast<double>(first + end - 1) / 2;
    }
    return ranks;
}

} // namespace

Parents RouletteReproduction::operator()(std::span<const double> fitness, std::size_t count,
                                         RandomStream& random) const {
    RouletteWheel wheel(fitness);
    if (wheel.empty())
        return std::nullopt;
    std::vector<double> turns(count);
    std::ranges::generate(turns, [&] { return random.uniform(); });
    return wheel.sectors(std::move(turns));
}

Parents UniversalReproduction::operator()(std::span<const double> fitness, std::size_t count,
                                          RandomStream& random) const {
    RouletteWheel wheel(fitness);
    if (wheel.empty())
        return std::nullopt;
    return sample_universally(wheel, count, random);
}

Parents ScaledReproduction::operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
    return sample_universally(RouletteWheel(scaled_copies(fitness, best)), count, random);
}

Parents RankingReproduction::operator()(std::span<const double> fitness, std::size_t count,
                                        RandomStream& random) const {
    std::vector<double> copies = ranks_of(fitness);
    double last = std::max(static_cast<double>(fitness.size()) - 1, 1.0);
    for (double& each : copies)
        each = 2 - best + 2 * (best - 1) * each / last;
    return sample_universally(RouletteWheel(copies), count, random);
}

Parents TournamentReproduction::operator()(std::span<const double> fitness, std::size_t count,
                                           RandomStream& random) const {
    auto draw = [&] { return random.below(static_cast<std::uint32_t>(fitness.size())); };
    std::vector<std::size_t> parents(count);
    for (std::size_t& parent : parents) {
        parent = draw();
        for (std::size_t i = 1; i < size; ++i)
            if (std::size_t other = draw(); fitness[other] > fitness[parent])
                parent = other;
    }
    return parents;
}

Parents OwnReproduction::operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
    return tried([&] {
        Parents parents = choose_(fitness, count, random);
        auto there_is = [&](std::size_t parent) { return parent < fitness.size(); };
        require(!parents || (parents->size() == count && std::ranges::all_of(*parents, there_is)),
                "it must choose exactly the requested number of parents, all from the population");
        return parents;
    });
}

Parents Reproduction::operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
    return std::visit([&](const auto& way) { return way(fitness, count, random); }, policy());
}

} // namespace placedpar
