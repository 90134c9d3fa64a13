#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A part of the work of one generation: error evaluations first ... last - 1. Evaluation e is of individual e / window
/// at sample e % window.
struct Share {
    std::size_t first = 0, last = 0;
    std::size_t window = 1; ///< samples in the window

    std::size_t evaluations() const { return last - first; }
    std::size_t first_individual() const { return first / window; }
    /// The individuals that it touches, whole or in part.
    std::size_t individuals() const { return first == last ? 0 : (last - 1) / window - first_individual() + 1; }
};

/// How the evaluations of a generation are split between a master and its slaves.
enum class Split {
    individuals, ///< whole individuals, dealt out equally; the first evaluators get one more
    demand,      ///< whole individuals, one at a time to each evaluator that is idle
    evaluations  ///< single error evaluations, dealt out equally
};

/// The slaves' shares, which are equal, and after them the master's: `own_share` of a slave's, rounded down.
/// REQUIRES: window > 0, 0 <= own_share <= 1. Split::demand deals as Split::individuals.
std::vector<Share> deal(std::size_t population, std::size_t window, std::size_t slaves, Split, double own_share = 1);

/// The most individuals that one message can be about, for any window: of the slaves' shares that deal() makes (for
/// Split::evaluations sometimes one too high); one on demand. REQUIRES: slaves > 0.
std::size_t most_individuals(std::size_t population, std::size_t slaves, Split, double own_share = 1);

/// The contribution of the share to the fitness of each individual that it touches. `strings` are those individuals.
std::vector<double> evaluate_share(const SearchProblem&, const Share&, std::span<const Genome> strings,
                                   std::span<const Sample> window, double bias);

/// Adds them to the fitness of the whole population.
void add_terms(const Share&, std::span<const double> terms, std::span<double> fitness);

} // namespace placedpar
