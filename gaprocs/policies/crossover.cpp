#include "gaprocs/policies/crossover.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace placedpar {

namespace {

/// The next individual behind the first that differs from it in two bits or more becomes its neighbour.
/// False where there is none.
bool mate_by_difference(std::span<Genome> unmated) {
    auto differs = [&](const Genome& other) { return difference(unmated.front(), other) >= 2; };
    auto mate = std::find_if(unmated.begin() + 1, unmated.end(), differs);
    if (mate == unmated.end())
        return false;
    std::iter_swap(unmated.begin() + 1, mate);
    return true;
}

} // namespace

void OnePointCrossover::operator()(Genome& a, Genome& b, RandomStream& random) const {
    swap_leading(a, b, 1 + random.below(static_cast<std::uint32_t>(a.size() - 1)));
}

void TwoPointCrossover::operator()(Genome& a, Genome& b, RandomStream& random) const {
    auto places = static_cast<std::uint32_t>(a.size());
    std::size_t first = random.below(places), second = random.below(places - 1);
    second += second >= first; // another one
    swap_leading(a, b, first);
    swap_leading(a, b, second);
}

void UniformCrossover::operator()(Genome& a, Genome& b, RandomStream& random) const {
    swap_where(a, b, Genome::random(a.size(), random));
}

void DifferenceCrossover::operator()(Genome& a, Genome& b, RandomStream& random) const {
    std::size_t first = first_difference(a, b), last = last_difference(a, b);
    swap_leading(a, b, first + 1 + random.below(static_cast<std::uint32_t>(last - first)));
}

void Crossover::operator()(std::span<Genome> population, double probability, RandomStream& random) const {
    if (population.empty() || population.front().size() < 2)
        return;
    auto cross_all = [&]<class Way>(const Way& cross) {
        for (std::size_t i = 0; i + 1 < population.size(); i += 2) {
            if (!random.chance(probability))
                continue;
            if constexpr (std::is_same_v<Way, DifferenceCrossover>)
                if (!mate_by_difference(population.subspan(i)))
                    continue;
            cross(population[i], population[i + 1], random);
        }
    };
    std::visit(cross_all, policy());
}

} // namespace placedpar
