// These rivals are two algorithms of pagmo 2.18 (ESA): its genetic algorithm, which works on real numbers, and its
// differential evolution. Debian's pagmo is built with Boost 1.74, whose headers only this file includes. Therefore
// this file is compiled to a shared library that exports pagmo() alone.

#include "bench/identification/contest.hpp"

#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <utility>

namespace placedpar {

using namespace hydraulics;

namespace {

/// The problem in the form of pagmo, which minimises. Pagmo copies a problem into every population, so a moved window
/// needs a new problem.
struct WindowProblem {
    const Transient* transient = nullptr;
    std::span<const LinkSample> window;

    pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {-transient->fitness(x[0], window)}; }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {{0.0}, {Transient::largest}}; }
};

template <typename Algorithm>
Answer identify(const Transient& transient, Algorithm algorithm) {
    auto seed = static_cast<unsigned>(transient.seed);
    algorithm.set_seed(seed);
    std::uint64_t evaluations = 0;
    pagmo::population population;
    for (std::size_t number = 0; number < transient.windows(); ++number) {
        pagmo::problem problem(WindowProblem{&transient, transient.window_at(number)});
        pagmo::population next(problem, number == 0 ? Transient::population : 0, seed);
        for (const pagmo::vector_double& x : population.get_x())
            next.push_back(x); // evaluates x in the new window, which counts as the first generation
        population = algorithm.evolve(std::move(next));
        evaluations += population.get_problem().get_fevals() * transient.window_at(number).size();
    }
    return {population.champion_x()[0], evaluations};
}

constexpr unsigned generations = Transient::trials - 1;

Answer genetic(const Transient& transient) {
    return identify(transient, pagmo::sga(generations, 0.8, 10, 0.1, 20, 2, "sbx", "polynomial", "tournament"));
}

Answer differential_evolution(const Transient& transient) {
    // With tolerances of 0 the search never ends early.
    return identify(transient, pagmo::de(generations, 0.8, 0.9, 2, 0, 0));
}

} // namespace

#pragma GCC visibility push(default)
std::vector<Contestant> pagmo() { return {{"pagmo sga", genetic}, {"pagmo de", differential_evolution}}; }
#pragma GCC visibility pop

} // namespace placedpar
