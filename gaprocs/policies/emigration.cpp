#include "gaprocs/policies/emigration.hpp"

#include "gaprocs/policies/individual.hpp"
#include "runtime/random.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <numeric>
#include <variant>

namespace placedpar {

namespace {

/// Chooses `count` different individuals. choose(left) returns a position in `left`, the list of the individuals not
/// yet chosen.
template <class Choose>
std::vector<std::size_t> choose_different(std::size_t population, std::size_t count, Choose choose) {
    std::vector<std::size_t> left(population), chosen;
    std::iota(left.begin(), left.end(), std::size_t{0});
    while (chosen.size() < count) {
        auto place = left.begin() + static_cast<std::ptrdiff_t>(choose(left));
        chosen.push_back(*place);
        left.erase(place);
    }
    return chosen;
}

std::size_t place_among(const std::vector<std::size_t>& left, RandomStream& random) {
    return random.below(static_cast<std::uint32_t>(left.size()));
}

} // namespace

std::vector<std::size_t> BestEmigration::operator()(std::span<const double> fitness, RandomStream&) const {
    return best_indices(fitness, count);
}

std::vector<std::size_t> RandomEmigration::operator()(std::span<const double> fitness, RandomStream& random) const {
    return choose_different(fitness.size(), count, [&](const auto& left) { return place_among(left, random); });
}

std::vector<std::size_t> TournamentEmigration::operator()(std::span<const double> fitness, RandomStream& random) const {
    return choose_different(fitness.size(), count, [&](const auto& left) {
        std::size_t best = place_among(left, random);
        for (std::size_t i = 1; i < size; ++i)
            if (std::size_t other = place_among(left, random); fitness[left[other]] > fitness[left[best]])
                best = other;
        return best;
    });
}

std::vector<std::size_t> OwnEmigration::operator()(std::span<const double> fitness, RandomStream& random) const {
    return tried([&] {
        std::vector<std::size_t> chosen = choose_(fitness, random);
        require(chosen.size() == count && are_different(chosen, 0, fitness.size()),
                "it must choose `count` different individuals of the population");
        return chosen;
    });
}

std::size_t Emigration::count() const {
    return std::visit([](const auto& way) { return way.count; }, policy());
}

void Emigration::validate_for(std::size_t population) const {
    if (count() > population)
        throw UserError(fmt::format("{} cannot leave a population of {}, expected at most {}",
                                    counted(count(), "emigrant"), population, population));
}

std::vector<std::size_t> Emigration::operator()(std::span<const double> fitness, RandomStream& random) const {
    validate_for(fitness.size());
    return std::visit([&](const auto& way) { return way(fitness, random); }, policy());
}

} // namespace placedpar
