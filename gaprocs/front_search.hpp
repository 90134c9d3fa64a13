#pragma once

#include "gaprocs/objective.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace placedpar {

class Checkpoints; // gaprocs/checkpoints.hpp

/// Returns the settings of a search like NSGA-II, the usual algorithm for several objectives (K. Deb, A. Pratap, S.
/// Agarwal and T. Meyarivan, 2002). The better half of the `population` individuals survives unchanged, and its
/// offspring replace the other half. Parents are chosen by stochastic universal sampling according to front_fitness().
/// Real vectors are bred by simulated binary crossover and polynomial mutation, binary strings by uniform crossover,
/// and permutations by order crossover. On average one character of each offspring mutates.
SearchSettings front_settings(const Representation&, std::size_t population);

/// Returns the fitness of each individual. order_of() (gaprocs/merit.hpp) sorts the individuals, the best first. In the
/// better half, fitness decreases in this order. In the other half, fitness is 0, so these individuals have no
/// offspring.
std::vector<double> front_fitness(std::span<const Merit>);

struct FrontIndividual {
    Genome genome;
    std::vector<double> parameters;
    std::vector<double> objectives; ///< with the problem's own signs, also if they are maximised
};

struct FrontResult {
    /// The survivors that satisfy all constraints and that no other survivor dominates. They are in ascending order of
    /// the first cost (the first objective, negated if it is maximised). Empty if no survivor is feasible.
    std::vector<FrontIndividual> front;
    double least_violation = 0; ///< least total violation of constraints by a survivor; 0 if a survivor is feasible
    std::uint64_t generations = 0;
    /// Number of individuals that this call evaluated; survivors are not evaluated again.
    std::uint64_t evaluations = 0;
};

/// Searches for the Pareto front of a problem with one or several objectives, with or without constraints. If several
/// individuals are equal, all but the first count as infeasible. For n survivors, pass front_settings(..., 2 * n). Such
/// a search makes n * (generations + 1) evaluations. `after_generation` is called with the number of each completed
/// generation; an exception from it ends the search. The search has the name "front" in the checkpoints. Throws what
/// SearchSettings::validate(), require_fitting_operators() and Search::go_on_from() throw, and UserError for a problem
/// that needs measurements, for 0 generations, or for an elite that is not half the population.
FrontResult search_front(const SearchProblem&, std::size_t generations, const SearchSettings&, RandomStream,
                         const std::function<void(std::uint64_t)>& after_generation = {}, Checkpoints* = nullptr);

} // namespace placedpar
