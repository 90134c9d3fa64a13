#include "gaprocs/operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace placedpar {

std::optional<std::vector<std::size_t>> RouletteReproduction::operator()(std::span<const double> fitness,
                                                                         std::size_t count,
                                                                         RandomStream& random) const {
    std::vector<double> wheel(fitness.size());
    double total = 0;
    for (std::size_t i = 0; i < fitness.size(); ++i)
        wheel[i] = total += fitness[i] > 0 ? fitness[i] : 0;
    if (!std::isfinite(total))
        throw std::invalid_argument("roulette: the fitness values add up beyond a double");
    if (total < std::numeric_limits<double>::min())
        return std::nullopt;
    std::vector<std::size_t> parents(count);
    for (std::size_t& parent : parents) {
        // The first sector that ends beyond the ball: never an empty one. uniform() is at most 1 - 2^-32, so
        // that the product is below the total even when rounded.
        double ball = random.uniform() * total;
        parent = static_cast<std::size_t>(std::upper_bound(wheel.begin(), wheel.end(), ball) - wheel.begin());
    }
    return parents;
}

void OnePointCrossover::operator()(std::span<Genome> population, RandomStream& random) const {
    for (std::size_t i = 0; i + 1 < population.size(); i += 2) {
        std::size_t length = population[i].size();
        if (length < 2 || !random.chance(probability))
            continue;
        std::size_t cut = 1 + random.below(static_cast<std::uint32_t>(length - 1));
        swap_leading(population[i], population[i + 1], cut);
    }
}

void BitMutation::operator()(std::span<Genome> population, RandomStream& random) const {
    for (Genome& genome : population)
        for (std::size_t bit = 0; bit < genome.size(); ++bit)
            if (random.chance(probability))
                genome.flip(bit);
}

std::vector<Genome> random_population(std::size_t count, std::size_t bits, RandomStream& random) {
    std::vector<Genome> population;
    population.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        population.push_back(Genome::random(bits, random));
    return population;
}

} // namespace placedpar
