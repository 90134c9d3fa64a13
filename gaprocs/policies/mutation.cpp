#include "gaprocs/policies/mutation.hpp"

#include "runtime/vector_width.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <variant>

namespace placedpar {

namespace {

double width_of(const RealVector& reals, std::size_t number) {
    return reals.range(number).high - reals.range(number).low;
}

/// Returns a random place other than `place`. All other places are equally likely.
std::size_t another_place(std::size_t place, std::size_t places, RandomStream& random) {
    return (place + 1 + random.below(static_cast<std::uint32_t>(places - 1))) % places;
}

using Drawn = std::array<std::uint32_t, 1024>;

/// Calls take(i) for each i < count with drawn[i] < limit. Such numbers are rare, so the loop tests eight comparisons
/// at once, and skips all eight numbers if none is below the limit.
template <class Take>
void for_each_below(std::uint64_t limit, const Drawn& drawn, std::size_t count, const Take& take) {
    if (limit == 0)
        return;
    in_vectors([&drawn, count, most = static_cast<std::uint32_t>(limit - 1), &take]<std::size_t width>() {
        std::array<std::uint8_t, std::tuple_size_v<Drawn>> below;
        for (std::size_t i = 0; i < below.size(); ++i)
            below[i] = drawn[i] <= most;
        for (std::size_t first = 0; first < count; first += sizeof(std::uint64_t)) {
            std::uint64_t any;
            std::memcpy(&any, &below[first], sizeof any);
            if constexpr (std::endian::native == std::endian::big)
                any = __builtin_bswap64(any);
            for (; any != 0; any &= any - 1)
                if (const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(any)) / 8; i < count)
                    take(i);
        }
    });
}

void swap_places(Genome& genome, std::size_t a, std::size_t b) {
    std::uint64_t at_a = genome.words()[a];
    genome.set_word(a, genome.words()[b]);
    genome.set_word(b, at_a);
}

} // namespace

void BitMutation::operator()(std::span<Genome> population, RandomStream& random) const {
    // A drawn number flips its bit if number * 2^-32 < probability, as in RandomStream::chance. Comparing whole numbers
    // avoids the conversion to double.
    const auto limit = static_cast<std::uint64_t>(std::ceil(probability * 0x1p32));
    const std::size_t length = population.empty() ? 0 : population.front().size();
    Drawn drawn;
    for (std::size_t first = 0, bits = population.size() * length; first < bits; first += drawn.size()) {
        const std::size_t count = std::min(drawn.size(), bits - first);
        random.fill(std::span(drawn).first(count));
        for_each_below(limit, drawn, count,
                       [&](std::size_t i) { population[(first + i) / length].flip((first + i) % length); });
    }
}

void DistanceMutation::operator()(std::span<Genome> population, RandomStream& random) const {
    const std::size_t length = population.empty() ? 0 : population.front().size();
    const double per_logarithm = 1 / std::log1p(-probability); // -0 for probability 1, -infinity for probability 0
    auto left = static_cast<double>(population.size() * length);
    for (std::size_t next = 0;; ++next) {
        // `distance` is the number of unchanged bits before the next flipped bit. The distance is at least n with
        // probability (1 - probability)^n.
        double distance = std::floor(std::log(1 - random.uniform()) * per_logarithm);
        left -= distance + 1;
        if (!(left >= 0)) // also true if `left` is NaN, from 0 times infinity
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

void PolynomialMutation::operator()(Genome& genome, std::size_t place, const Representation& representation,
                                    RandomStream& random) const {
    const RealVector& reals = representation.reals();
    const double width = width_of(reals, place), value = reals.value(genome, place), turn = random.uniform();
    const bool down = turn < 0.5;
    const double room = (down ? value - reals.range(place).low : reals.range(place).high - value) / width;
    const double part = down ? 2 * turn : 2 - 2 * turn; // uniform in 0 ... 1
    const double step = 1 - std::pow(part + (1 - part) * std::pow(1 - room, index + 1), 1 / (index + 1));
    reals.set(genome, place, value + (down ? -step : step) * width);
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
    if (representation.kind() == StringKind::permutation && representation.permutation().places() == 1)
        return;
    auto mutate_all = [&]<class Operator>(const Operator& mutate) {
        if constexpr (std::is_same_v<Operator, BitMutation> || std::is_same_v<Operator, DistanceMutation>)
            Operator{probability}(population, random);
        else if constexpr (std::is_same_v<Operator, OwnMutation>)
            mutate(population, probability, representation, random);
        else
            mutate_places(mutate, population, probability, representation, random);
    };
    std::visit(mutate_all, policy());
}

} // namespace placedpar
