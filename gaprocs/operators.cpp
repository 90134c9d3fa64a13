#include "gaprocs/operators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

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

std::optional<std::vector<std::size_t>>
RouletteReproduction::operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
    RouletteWheel wheel(fitness);
    if (wheel.empty())
        return std::nullopt;
    std::vector<std::size_t> parents(count);
    for (std::size_t& parent : parents)
        parent = wheel.sector(random.uniform());
    return parents;
}

std::optional<std::vector<std::size_t>>
UniversalReproduction::operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
    RouletteWheel wheel(fitness);
    if (wheel.empty())
        return std::nullopt;
    std::vector<std::size_t> parents = wheel.sectors(count, random.uniform());
    for (std::size_t left = parents.size(); left > 1; --left) // Fisher and Yates
        std::swap(parents[left - 1], parents[random.below(static_cast<std::uint32_t>(left))]);
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
    // number * 2^-32 < probability, in whole numbers: RandomStream::chance without its conversion to double.
    const auto limit = static_cast<std::uint64_t>(std::ceil(probability * 0x1p32));
    std::size_t to_draw = 0;
    for (const Genome& genome : population)
        to_draw += genome.size();
    std::array<std::uint32_t, 256> numbers;
    std::size_t drawn = 0, used = 0;
    for (Genome& genome : population)
        for (std::size_t bit = 0, bits = genome.size(); bit < bits; ++bit) {
            if (used == drawn) {
                drawn = std::min(numbers.size(), to_draw);
                to_draw -= drawn;
                used = 0;
                random.fill(std::span(numbers).first(drawn));
            }
            if (numbers[used++] < limit)
                genome.flip(bit);
        }
}

std::vector<Genome> random_population(std::size_t count, std::size_t bits, RandomStream& random) {
    std::vector<Genome> population;
    population.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        population.push_back(Genome::random(bits, random));
    return population;
}

} // namespace placedpar
