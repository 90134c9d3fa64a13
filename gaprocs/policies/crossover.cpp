#include "gaprocs/policies/crossover.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

namespace {

/// Looks for the next individual of `unmated` that differs from the first individual in at least two bits. Swaps the
/// individual found with the second individual and returns true. Returns false if no individual differs enough.
bool mate_by_difference(std::span<Genome> unmated) {
    auto differs = [&](const Genome& other) { return difference(unmated.front(), other) >= 2; };
    auto mate = std::find_if(unmated.begin() + 1, unmated.end(), differs);
    if (mate == unmated.end())
        return false;
    std::iter_swap(unmated.begin() + 1, mate);
    return true;
}

/// Draws two different numbers below `count`; every ordered pair is equally likely.
std::pair<std::size_t, std::size_t> two_of(std::size_t count, RandomStream& random) {
    auto places = static_cast<std::uint32_t>(count);
    std::size_t first = random.below(places), second = random.below(places - 1);
    return {first, second + (second >= first)};
}

/// Returns a mask for crossing real vectors: each 64-bit word, which selects one number, is all ones or all zeros, each
/// with probability 1/2.
Genome whole_words_at_random(std::size_t bits, RandomStream& random) {
    Genome mask(bits);
    for (std::size_t word = 0; word < bits / 64; ++word)
        if (random.chance(0.5))
            mask.set_word(word, ~std::uint64_t{0});
    return mask;
}

/// Makes an offspring by order crossover. The positions form a ring: position 0 follows the last position. At the
/// positions from `first` to `end` - 1 the offspring has the entries of `kept`. The missing entries follow from
/// position `end` on, in the order that they have in `other` from `end` on.
std::vector<std::size_t> ordered_offspring(const std::vector<std::size_t>& kept, const std::vector<std::size_t>& other,
                                           std::size_t first, std::size_t end) {
    std::size_t places = kept.size();
    std::vector<std::size_t> offspring(places);
    std::vector<bool> there(places);
    for (std::size_t i = first; i != end; i = (i + 1) % places) {
        offspring[i] = kept[i];
        there[kept[i]] = true;
    }
    std::size_t next = end;
    for (std::size_t i = 0; i < places; ++i)
        if (std::size_t each = other[(end + i) % places]; !there[each]) {
            offspring[next] = each;
            next = (next + 1) % places;
        }
    return offspring;
}

template <class Operator>
void cross_pair(const Operator& cross, Genome& a, Genome& b, const Representation& representation,
                RandomStream& random) {
    if constexpr (std::is_same_v<Operator, BlendCrossover> || std::is_same_v<Operator, SimulatedBinaryCrossover>)
        cross(a, b, representation.reals(), random);
    else if constexpr (std::is_same_v<Operator, OrderCrossover>)
        cross(a, b, representation.permutation(), random);
    else if constexpr (std::is_same_v<Operator, DifferenceCrossover>)
        cross(a, b, random);
    else
        cross(a, b, random, representation.unit());
}

} // namespace

void OnePointCrossover::operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit) const {
    const std::size_t characters = unit == 1 ? a.size() : a.size() / unit; // avoids a slow division
    swap_leading(a, b, unit * (1 + random.below(static_cast<std::uint32_t>(characters - 1))));
}

void TwoPointCrossover::operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit) const {
    auto [first, second] = two_of(a.size() / unit, random);
    swap_leading(a, b, unit * first);
    swap_leading(a, b, unit * second);
}

void UniformCrossover::operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit) const {
    swap_where(a, b, unit == 1 ? Genome::random(a.size(), random) : whole_words_at_random(a.size(), random));
}

void DifferenceCrossover::operator()(Genome& a, Genome& b, RandomStream& random) const {
    std::size_t first = first_difference(a, b), last = last_difference(a, b);
    swap_leading(a, b, first + 1 + random.below(static_cast<std::uint32_t>(last - first)));
}

void BlendCrossover::operator()(Genome& a, Genome& b, const RealVector& reals, RandomStream& random) const {
    for (std::size_t i = 0; i < reals.parameters(); ++i) {
        auto [low, high] = std::minmax({reals.value(a, i), reals.value(b, i)});
        double beyond = alpha * (high - low);
        for (Genome* offspring : {&a, &b})
            reals.set(*offspring, i, low - beyond + (high - low + 2 * beyond) * random.uniform());
    }
}

/// Returns an offspring's distance from the middle of the parents, as a multiple of a parent's distance from the
/// middle. `distance`: distance between the parents; `room`: distance from the nearer parent to the end of the range;
/// `turn`: uniform in 0 ... 1.
double SimulatedBinaryCrossover::spread(double distance, double room, double turn) const {
    const double most = 2 - std::pow(1 + 2 * room / distance, -(index + 1));
    const double scaled = turn * most;
    return std::pow(scaled <= 1 ? scaled : 1 / (2 - scaled), 1 / (index + 1));
}

void SimulatedBinaryCrossover::operator()(Genome& a, Genome& b, const RealVector& reals, RandomStream& random) const {
    for (std::size_t i = 0; i < reals.parameters(); ++i) {
        const auto [low, high] = std::minmax({reals.value(a, i), reals.value(b, i)});
        if (!random.chance(0.5) || low == high)
            continue;
        const double turn = random.uniform(), middle = low + (high - low) / 2, half = (high - low) / 2;
        const double below = middle - half * spread(high - low, low - reals.range(i).low, turn);
        const double above = middle + half * spread(high - low, reals.range(i).high - high, turn);
        const bool swapped = random.chance(0.5);
        reals.set(a, i, swapped ? above : below);
        reals.set(b, i, swapped ? below : above);
    }
}

void OrderCrossover::operator()(Genome& a, Genome& b, const Permutation& permutation, RandomStream& random) const {
    auto [first, end] = two_of(permutation.places(), random);
    auto order_a = permutation.decode(a), order_b = permutation.decode(b);
    a = permutation.encode(ordered_offspring(order_a, order_b, first, end));
    b = permutation.encode(ordered_offspring(order_b, order_a, first, end));
}

void Crossover::operator()(std::span<Genome> population, double probability, const Representation& representation,
                           RandomStream& random) const {
    if (population.empty() || representation.bits() < 2 * representation.unit())
        return;
    auto cross_all = [&]<class Operator>(const Operator& cross) {
        if constexpr (std::is_same_v<Operator, OwnCrossover>)
            cross(population, probability, representation, random);
        else
            for (std::size_t i = 0; i + 1 < population.size(); i += 2) {
                if (!random.chance(probability))
                    continue;
                if constexpr (std::is_same_v<Operator, DifferenceCrossover>)
                    if (!mate_by_difference(population.subspan(i)))
                        continue;
                cross_pair(cross, population[i], population[i + 1], representation, random);
            }
    };
    std::visit(cross_all, policy());
}

} // namespace placedpar
