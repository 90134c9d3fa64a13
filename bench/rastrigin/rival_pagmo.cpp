// These rivals are two algorithms of pagmo 2.18 (ESA): its genetic algorithm and its differential evolution. This file
// is compiled to a separate shared library, as in bench/identification.

#include "bench/rastrigin/contest.hpp"

#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <utility>

namespace placedpar {

namespace {

/// Holds a pointer to the valley, since pagmo copies problems.
struct ValleyProblem {
    Valley* valley = nullptr;

    pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {valley->objective(x)}; }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        return {pagmo::vector_double(Valley::dimensions, Valley::low),
                pagmo::vector_double(Valley::dimensions, Valley::high)};
    }
};

template <typename Algorithm>
void descend(Valley& valley, std::uint64_t seed, pagmo::population::size_type individuals, Algorithm algorithm) {
    algorithm.set_seed(static_cast<unsigned>(seed));
    algorithm.evolve(pagmo::population(ValleyProblem{&valley}, individuals, static_cast<unsigned>(seed)));
}

constexpr unsigned endless = 1'000'000'000; // generations; the valley ends every search earlier

void genetic(Valley& valley, std::uint64_t seed) {
    descend(valley, seed, 20, pagmo::sga(endless, 0.9, 1, 1.0 / Valley::dimensions, 20, 2, "sbx", "polynomial"));
}
void genetic_by_default(Valley& valley, std::uint64_t seed) { descend(valley, seed, 50, pagmo::sga(endless)); }

void differential(Valley& valley, std::uint64_t seed) {
    descend(valley, seed, 20, pagmo::de(endless, 0.5, 0.1, 2, 0, 0)); // only the valley ends the search
}
void differential_by_default(Valley& valley, std::uint64_t seed) {
    descend(valley, seed, 50, pagmo::de(endless, 0.8, 0.9, 2, 0, 0));
}

} // namespace

#pragma GCC visibility push(default)
std::vector<Contestant> pagmo() {
    return {{"pagmo sga", genetic},
            {"... its defaults, 50", genetic_by_default},
            {"pagmo de", differential},
            {"... its defaults, 50", differential_by_default}};
}
#pragma GCC visibility pop

} // namespace placedpar
