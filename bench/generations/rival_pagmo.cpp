// These rivals are two algorithms of pagmo 2.18 (ESA): its genetic algorithm, which works on real numbers, and its
// differential evolution. This file is compiled to a separate shared library, as in bench/identification.

#include "bench/generations/contest.hpp"

#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <utility>

namespace placedpar {

namespace {

PoleZeroPlant plant_of(const pagmo::vector_double& x) { return {x[0], x[1], x[2], x[3], x[4], x[5]}; }

/// The problem in the form of pagmo, which minimises. Pagmo copies a problem into every population, so a moved window
/// needs a new problem.
struct WindowProblem {
    std::span<const std::vector<double>> window;

    pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {-Chase::fitness(plant_of(x), window)}; }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        return {{Chase::low.begin(), Chase::low.end()}, {Chase::high.begin(), Chase::high.end()}};
    }
};

template <typename Algorithm>
Answer follow(const Chase& chase, Algorithm algorithm) {
    auto seed = static_cast<unsigned>(chase.seed);
    algorithm.set_seed(seed);
    pagmo::population population;
    Answer answer;
    for (std::size_t number = 0; number < chase.windows(); ++number) {
        pagmo::problem problem(WindowProblem{chase.window_at(number)});
        pagmo::population next(problem, number == 0 ? Chase::population : 0, seed);
        for (const pagmo::vector_double& x : population.get_x())
            next.push_back(x); // evaluates x in the new window, which counts as the first generation
        population = algorithm.evolve(std::move(next));
        PoleZeroPlant best = plant_of(population.champion_x());
        answer.poles.push_back({best.alpha, best.beta});
    }
    return answer;
}

constexpr unsigned generations = Chase::trials - 1;

Answer genetic(const Chase& chase) {
    return follow(chase, pagmo::sga(generations, 0.8, 10, 0.1, 20, 2, "sbx", "polynomial", "tournament"));
}

Answer differential_evolution(const Chase& chase) {
    // With tolerances of 0 the search never ends early, so it uses the same budget as the other contestants.
    return follow(chase, pagmo::de(generations, 0.8, 0.9, 2, 0, 0));
}

} // namespace

#pragma GCC visibility push(default)
std::vector<Contestant> pagmo() { return {{"pagmo sga", genetic}, {"pagmo de", differential_evolution}}; }
#pragma GCC visibility pop

} // namespace placedpar
