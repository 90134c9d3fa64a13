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

/// Returns the settings of a search in the manner of NSGA-II (K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, 2002).
/// The better half of the `population` individuals survives unchanged, and its offspring replace the other half.
/// Parents are chosen by stochastic universal sampling over front_fitness(). Real vectors are bred by simulated binary
/// crossover and polynomial mutation, binary strings by uniform crossover, and permutations by order crossover. On
/// average one character of each offspring mutates.
SearchSettings front_settings(const Representation&, std::size_t population);

/// Returns the fitness of each individual. In the better half, fitness decreases in the order of order_of()
/// (gaprocs/merit.hpp); in the other half it is 0, so these individuals have no offspring.
std::vector<double> front_fitness(std::span<const Merit>);

struct FrontIndividual {
    Genome genome;
    std::vector<double> parameters;
    std::vector<double> objectives; ///< as the problem computes them, not negated
};

struct FrontResult {
    /// The feasible survivors that no other dominates, in ascending order of the first cost; empty if no survivor is
    /// feasible.
    std::vector<FrontIndividual> front;
    double least_violation = 0; ///< least violation of a survivor; 0 if one is feasible
    std::uint64_t generations = 0;
    std::uint64_t evaluations = 0; ///< number of individuals evaluated by this call; survivors are not evaluated again
};

/// Searches for the front of a problem with one or several objectives, with or without constraints. If several
/// individuals are equal, all but the first count as infeasible. For n survivors, pass front_settings(..., 2 * n); the
/// search then makes n * (generations + 1) evaluations. `after_generation` is called with the number of each completed
/// generation; an exception from it ends the search. In checkpoints the search has the name "front". Throws what
/// SearchSettings::validate(), require_fitting_operators() and Search::go_on_from() throw, and UserError for a problem
/// with a record, for 0 generations or for an elite that is not half the population.
FrontResult search_front(const SearchProblem&, std::size_t generations, const SearchSettings&, RandomStream,
                         const std::function<void(std::uint64_t)>& after_generation = {}, Checkpoints* = nullptr);

} // namespace placedpar
