#include "gaprocs/policies/mutation.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

namespace placedpar {

namespace {

double width_of(const RealVector& reals, std::size_t number) {
    return reals.range(number).high - reals.range(number).low;
}

/// Each of the others with the same chance.
std::size_t another_place(std::size_t place, std::size_t places, RandomStream& random) {
    return (place + 1 + random.below(static_cast<std::uint32_t>(places - 1))) % places;
}

void swap_places(Genome& genome, std::size_t a, std::size_t b) {
    std::uint64_t at_a = genome.words()[a];
    genome.set_word(a, genome.words()[b]);
    genome.set_word(b, at_a);
}

} // namespace

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

void DistanceMutation::operator()(std::span<Genome> population, RandomStream& random) const {
    const std::size_t length = population.empty() ? 0 : population.front().size();
    const double per_logarithm = 1 / std::log1p(-probability); // -0 for the certainty, -infinity for the impossible
    auto left = static_cast<double>(population.size() * length);
    for (std::size_t next = 0;; ++next) {
        // That the next `distance` bits stay has the chance (1 - probability)^distance.
        double distance = std::floor(std::log(1 - random.uniform()) * per_logarithm);
        left -= distance + 1;
        if (!(left >= 0)) // nor when it is not a number: 0 times infinity
            return;
        next += static_cast<std::size_t>(distance);
        population[next / length].flip(next % length);
    }
}

void GaussianMutation::operator()(Genome& genome, std::size_t place, const Representation& representation,
                                  RandomStream& random) const {
    const RealVector& reals = representation.reals();
    reals.set(genome, place, reals.value(genome, place) + deviation * width_of(reals, place) * random.normal());
}

void BreederMutation::operator()(Genome& genome, std::size_t place, const Representation& representation,
                                 RandomStream& random) const {
    const RealVector& reals = representation.reals();
    double step = range * width_of(reals, place) * std::exp2(-precision * random.uniform());
    reals.set(genome, place, reals.value(genome, place) + (random.chance(0.5) ? step : -step));
}

void UniformMutation::operator()(Genome& genome, std::size_t place, const Representation& representation,
                                 RandomStream& random) const {
    const RealVector& reals = representation.reals();
    reals.set(genome, place, reals.range(place).low + width_of(reals, place) * random.uniform());
}

void SwapMutation::operator()(Genome& genome, std::size_t place, const Representation& representation,
                              RandomStream& random) const {
    swap_places(genome, place, another_place(place, representation.permutation().places(), random));
}

void InversionMutation::operator()(Genome& genome, std::size_t place, const Representation& representation,
                                   RandomStream& random) const {
    std::size_t places = representation.permutation().places();
    std::size_t last = another_place(place, places, random);
    std::size_t length = (last + places - place) % places + 1;
    for (std::size_t i = 0; i < length / 2; ++i)
        swap_places(genome, (place + i) % places, (last + places - i) % places);
}

void Mutation::operator()(std::span<Genome> population, double probability, const Representation& representation,
                          RandomStream& random) const {
    std::size_t places = representation.bits() / representation.unit();
    auto mutate_all = [&]<class Way>(const Way& mutate) {
        if constexpr (std::is_same_v<Way, BitMutation> || std::is_same_v<Way, DistanceMutation>)
            Way{probability}(population, random);
        else if (representation.kind() == StringKind::real || places > 1)
            for (Genome& genome : population)
                for (std::size_t place = 0; place < places; ++place)
                    if (random.chance(probability))
                        mutate(genome, place, representation, random);
    };
    std::visit(mutate_all, policy());
}

} // namespace placedpar
