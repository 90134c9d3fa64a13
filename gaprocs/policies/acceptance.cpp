#include "gaprocs/policies/acceptance.hpp"

#include "runtime/random.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

/// Chooses, for each immigrant, the individual that it replaces. `candidates`: individuals that may be replaced, each
/// at most once. choose(immigrant, left) receives the candidates that are left, and returns the position of the chosen
/// candidate among them.
template <class Choose>
Places give_places(const IslandPopulation& island, std::span<const Individual> immigrants,
                   std::vector<std::size_t> candidates, bool only_if_better, Choose choose) {
    Places places;
    for (const Individual& immigrant : immigrants) {
        auto chosen = candidates.begin() + static_cast<std::ptrdiff_t>(choose(immigrant, candidates));
        if (only_if_better && !(immigrant.fitness > island.fitness[*chosen])) {
            places.emplace_back();
            continue;
        }
        places.emplace_back(*chosen);
        candidates.erase(chosen);
    }
    return places;
}

std::uint32_t random_candidate(const std::vector<std::size_t>& candidates, RandomStream& random) {
    return random.below(static_cast<std::uint32_t>(candidates.size()));
}

std::vector<std::size_t> all_but_elite(const IslandPopulation& island) {
    return worst_indices(island.fitness, island.fitness.size() - island.elite);
}

} // namespace

Places WorstAcceptance::operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                                   RandomStream&) const {
    auto worst = worst_indices(island.fitness, immigrants.size());
    return give_places(island, immigrants, std::move(worst), only_if_better,
                       [](const Individual&, const auto&) { return 0; });
}

Places RandomAcceptance::operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                                    RandomStream& random) const {
    return give_places(island, immigrants, all_but_elite(island), only_if_better,
                       [&](const Individual&, const auto& left) { return random_candidate(left, random); });
}

Places AlikeAcceptance::operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                                   RandomStream&) const {
    auto distance = [&](const Genome& a, const Genome& b) {
        return island.representation ? island.representation->distance(a, b) : static_cast<double>(difference(a, b));
    };
    auto most_alike = [&](const Individual& immigrant, const std::vector<std::size_t>& candidates) {
        auto more_alike = [&](std::size_t a, std::size_t b) {
            return distance(island.strings[a], immigrant.genome) < distance(island.strings[b], immigrant.genome);
        };
        return std::min_element(candidates.begin(), candidates.end(), more_alike) - candidates.begin();
    };
    return give_places(island, immigrants, all_but_elite(island), only_if_better, most_alike);
}

Places OffspringAcceptance::operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                                       RandomStream& random) const {
    std::vector<std::size_t> candidates(island.strings.size() - island.elite);
    std::iota(candidates.begin(), candidates.end(), island.elite);
    return give_places(island, immigrants, std::move(candidates), false,
                       [&](const Individual&, const auto& left) { return random_candidate(left, random); });
}

Places OwnAcceptance::operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                                 RandomStream& random) const {
    return tried([&] {
        Places places = choose_(island, immigrants, random);
        std::vector<std::size_t> taken, free = all_but_elite(island);
        for (const auto& place : places)
            if (place)
                taken.push_back(*place);
        auto is_free = [&](std::size_t place) { return std::ranges::count(free, place) > 0; };
        require(places.size() == immigrants.size() && are_different(taken, 0, island.strings.size()) &&
                    std::ranges::all_of(taken, is_free),
                "for each immigrant it must return nothing, or the index of an individual outside the elite; no two "
                "immigrants may have the same index");
        return places;
    });
}

void Acceptance::validate_for(std::size_t immigrants, std::size_t population, std::size_t elite) {
    if (immigrants > population - elite)
        throw UserError(fmt::format("{} {} in one exchange to an island of {} with an elite of {}; expected at most {}",
                                    counted(immigrants, "immigrant"), immigrants == 1 ? "comes" : "come",
                                    counted(population, "individual"), elite, population - elite));
}

Places Acceptance::operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                              RandomStream& random) const {
    validate_for(immigrants.size(), island.strings.size(), island.elite);
    return std::visit([&](const auto& way) { return way(island, immigrants, random); }, policy());
}

} // namespace placedpar
