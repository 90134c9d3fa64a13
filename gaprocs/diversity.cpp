#include "gaprocs/diversity.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace placedpar {

namespace {

/// Adds a coordinate with the number `which` to the spread of a population, whose individuals are points in space. The
/// coordinate is 1 for `count` individuals and 0 for the others.
void add_count(Spread& spread, std::uint64_t which, std::uint64_t count) {
    auto individuals = static_cast<double>(spread.individuals), ones = static_cast<double>(count);
    spread.centre.push_back({which, ones / individuals});
    spread.squares += ones * (individuals - ones) / individuals;
}

std::vector<std::uint32_t> ones_of(std::span<const Genome> population, std::size_t bits) {
    std::vector<std::uint32_t> counts(bits);
    for (const Genome& genome : population) {
        std::size_t first = 0;
        for (std::uint64_t word : genome.words()) {
            for (; word != 0; word &= ~(0x8000000000000000u >> std::countl_zero(word)))
                ++counts[first + static_cast<std::size_t>(std::countl_zero(word))];
            first += 64;
        }
    }
    return counts;
}

Spread spread_of_bits(std::span<const Genome> population, std::size_t bits) {
    Spread spread{StringKind::binary, static_cast<double>(bits), population.size()};
    auto counts = ones_of(population, bits);
    for (std::size_t bit = 0; bit < bits; ++bit)
        if (counts[bit] > 0)
            add_count(spread, bit, counts[bit]);
    return spread;
}

/// Returns the real number with index `number` in each string, scaled so that 0 and 1 are the ends of the number's
/// range.
std::vector<double> places_of(std::span<const Genome> population, const RealVector& reals, std::size_t number) {
    auto [low, high] = reals.range(number);
    std::vector<double> places;
    for (const Genome& genome : population)
        places.push_back((reals.value(genome, number) - low) / (high - low));
    return places;
}

double mean_of_places(std::span<const double> places) {
    double sum = 0;
    for (double place : places)
        sum += place;
    return sum / static_cast<double>(places.size());
}

double squares_about(double mean, std::span<const double> places) {
    double squares = 0;
    for (double place : places)
        squares += (place - mean) * (place - mean);
    return squares;
}

Spread spread_of_reals(std::span<const Genome> population, const RealVector& reals) {
    Spread spread{StringKind::real, static_cast<double>(reals.parameters()), population.size()};
    for (std::size_t i = 0; !population.empty() && i < reals.parameters(); ++i) {
        auto places = places_of(population, reals, i);
        double mean = mean_of_places(places);
        spread.centre.push_back({i, mean});
        spread.squares += squares_about(mean, places);
    }
    return spread;
}

/// Returns a number for each pair of neighbouring places in each tour, in ascending order.
std::vector<std::uint64_t> neighbours_in(std::span<const Genome> tours, const Permutation& permutation) {
    std::vector<std::uint64_t> pairs;
    for (const Genome& genome : tours) {
        auto tour = permutation.decode(genome);
        for (std::size_t i = 0; i < tour.size(); ++i) {
            auto [first, second] = std::minmax(tour[i], tour[(i + 1) % tour.size()]);
            pairs.push_back(first * tour.size() + second);
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

/// Computes the spread of tours. The squared distance of two tours is the number of pairs of neighbours that only one
/// of the two tours has, which is twice Representation::distance().
Spread spread_of_tours(std::span<const Genome> population, const Permutation& permutation) {
    Spread spread{StringKind::permutation, 2 * static_cast<double>(permutation.places()), population.size()};
    auto pairs = neighbours_in(population, permutation);
    for (auto first = pairs.begin(); first != pairs.end();) {
        auto end = std::upper_bound(first, pairs.end(), *first);
        add_count(spread, *first, std::min(static_cast<std::uint64_t>(end - first), std::uint64_t{spread.individuals}));
        first = end;
    }
    return spread;
}

double diversity_of(double squared_distance, const Spread& like) {
    double share = squared_distance / like.greatest;
    return like.kind == StringKind::real ? std::sqrt(share) : share;
}

/// Steps through the coordinates of the centres of several populations. At each step it holds the same coordinate of
/// all centres.
class CentresInStep {
public:
    explicit CentresInStep(std::span<const Spread> populations)
        : populations_(populations), next_(populations.size(), 0), means_(populations.size()) {}

    /// Moves to the next coordinate that is in Spread::centre of at least one population. In the other populations this
    /// coordinate is 0. Returns false if there are no more coordinates.
    bool step() {
        constexpr auto none = std::numeric_limits<std::uint64_t>::max();
        std::uint64_t which = none;
        for (std::size_t i = 0; i < populations_.size(); ++i)
            if (next_[i] < populations_[i].centre.size())
                which = std::min(which, populations_[i].centre[next_[i]].which);
        for (std::size_t i = 0; which != none && i < populations_.size(); ++i) {
            const auto& centre = populations_[i].centre;
            bool here = next_[i] < centre.size() && centre[next_[i]].which == which;
            means_[i] = here ? centre[next_[i]++].mean : 0;
        }
        return which != none;
    }
    std::span<const double> means() const { return means_; }

private:
    std::span<const Spread> populations_;
    std::vector<std::size_t> next_;
    std::vector<double> means_; ///< the current coordinate of each population's centre
};

} // namespace

Spread spread_of(std::span<const Genome> population, const Representation& representation) {
    switch (representation.kind()) {
    case StringKind::binary: break;
    case StringKind::real: return spread_of_reals(population, representation.reals());
    case StringKind::permutation: return spread_of_tours(population, representation.permutation());
    }
    return spread_of_bits(population, representation.bits());
}

double diversity_within(const Spread& population) {
    if (population.individuals < 2)
        return 0;
    return diversity_of(2 * population.squares / static_cast<double>(population.individuals - 1), population);
}

/// Computes the mean squared distance of two individuals from different populations, a sum of three terms. The first
/// two terms are, for each of the two populations, the mean squared distance of its individuals from its centre. The
/// third term is the squared distance of the two centres. The mean of the third term over all pairs of populations
/// follows, without a loop over pairs, from the distances of the centres from their mean.
double diversity_between(std::span<const Spread> populations) {
    auto count = static_cast<double>(populations.size());
    double from_own = 0, of_centres = 0;
    for (const Spread& each : populations)
        from_own += each.squares / static_cast<double>(each.individuals);
    for (CentresInStep centres(populations); centres.step();)
        of_centres += squares_about(mean_of_places(centres.means()), centres.means());
    return diversity_of(2 * from_own / count + 2 * of_centres / (count - 1), populations.front());
}

double fixation(double within, double between) { return between == 0 ? 0 : 1 - within / between; }

} // namespace placedpar
