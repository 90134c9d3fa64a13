#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// A part of the work of one generation, which one slave or the master does: the error evaluations `first` ... `last` -
/// 1. Evaluation e computes the error of individual e / `window` at sample e % `window`.
struct Share {
    std::size_t first = 0, last = 0;
    std::size_t window = 1; ///< number of samples over which each individual is evaluated

    std::size_t evaluations() const { return last - first; }
    std::size_t first_individual() const { return first / window; }
    /// Returns the number of individuals with at least one evaluation in the share.
    std::size_t individuals() const { return first == last ? 0 : (last - 1) / window - first_individual() + 1; }
};

/// The rule by which a master and its slaves share the evaluations of a generation.
enum class Split {
    individuals, ///< whole individuals, the same number for each slave, or one more for the first slaves
    demand,      ///< whole individuals, one at a time, each for an idle slave or for the idle master
    evaluations  ///< single error evaluations, the same number for each slave, or one more for the first slaves
};

/// Returns a share for each slave, followed by the master's share. The master's share is `own_share` times a slave's
/// share, rounded down. Split::demand gives the same shares as Split::individuals. REQUIRES: window > 0, 0 <= own_share
/// <= 1.
std::vector<Share> deal(std::size_t population, std::size_t window, std::size_t slaves, Split, double own_share = 1);

/// Returns an upper bound for the number of individuals in a slave's task, from which the longest message follows. It
/// holds for any length of the window. The bound is exact for Split::individuals, may be one individual too high for
/// Split::evaluations, and is 1 for Split::demand. REQUIRES: slaves > 0.
std::size_t most_individuals(std::size_t population, std::size_t slaves, Split, double own_share = 1);

/// Returns, for each individual of the share, the sum of the fitness terms (one for each sample) that the share
/// contains. `strings`: the individuals of the share.
std::vector<double> evaluate_share(const SearchProblem&, const Share&, std::span<const Genome> strings,
                                   std::span<const Sample> window, double bias);

/// Adds the result of evaluate_share() to the fitness of the population.
void add_terms(const Share&, std::span<const double> terms, std::span<double> fitness);

} // namespace placedpar
