#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A part of the work of one generation: error evaluations first ... last - 1. Evaluation e belongs to individual e /
/// window and sample e % window.
struct Share {
    std::size_t first = 0, last = 0;
    std::size_t window = 1; ///< samples in the window

    std::size_t evaluations() const { return last - first; }
    std::size_t first_individual() const { return first / window; }
    /// Returns the number of individuals of which the share has evaluations, all or some.
    std::size_t individuals() const { return first == last ? 0 : (last - 1) / window - first_individual() + 1; }
};

/// How the evaluations of a generation are split between a master and its slaves.
enum class Split {
    individuals, ///< whole individuals, dealt out equally; the first evaluators get one more
    demand,      ///< whole individuals, one at a time to each evaluator that is idle
    evaluations  ///< single error evaluations, dealt out equally
};

/// Returns a share for each slave, equal to within one unit, followed by the master's, which is `own_share` times a
/// slave's, rounded down. REQUIRES: window > 0, 0 <= own_share <= 1. Split::demand deals as Split::individuals.
std::vector<Share> deal(std::size_t population, std::size_t window, std::size_t slaves, Split, double own_share = 1);

/// Returns an upper bound, for any window, of the individuals in one task for a slave as deal() makes it: exact for
/// Split::individuals, at times one too high for Split::evaluations. Split::demand: 1. REQUIRES: slaves > 0.
std::size_t most_individuals(std::size_t population, std::size_t slaves, Split, double own_share = 1);

/// Returns the contribution of the share to the fitness of each of its individuals, whose strings are `strings`.
std::vector<double> evaluate_share(const SearchProblem&, const Share&, std::span<const Genome> strings,
                                   std::span<const Sample> window, double bias);

/// Adds the terms that evaluate_share() returned to the fitness of the population.
void add_terms(const Share&, std::span<const double> terms, std::span<double> fitness);

} // namespace placedpar
