#pragma once

#include "gaprocs/search.hpp"
#include "gaprocs/search_observer.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

class Checkpoints;    // gaprocs/checkpoints.hpp
class SearchProgress; // gaprocs/search_progress.hpp

/// The answer of a search after a sample of measurements: the best individual found.
struct Estimate {
    std::size_t sample; ///< number of the sample in the record, from 0
    Individual best;    ///< best individual of the last generation before the next sample
    std::vector<double> parameters;
};

struct SearchResult {
    /// One for each sample, except the first samples, before there are enough for a generation.
    std::vector<Estimate> estimates;
    std::uint64_t generations = 0;
    std::uint64_t redraws = 0;
    std::vector<Genome> population; ///< population after the last generation, not yet evaluated

    /// Returns the fittest of all estimates; among equals the first. Only for a problem with an objective: with
    /// measurements, fitness values after different samples are not comparable. Throws std::logic_error if there are no
    /// estimates.
    const Estimate& best() const;
};

/// Completes the result of a search that continues from the checkpoint of earlier runs: if the problem has an
/// objective, adds the best individual of the earlier runs to the estimates.
void add_earlier_best(SearchResult&, const SearchProblem&, const SearchProgress&, const Search&);

/// Returns the fitness of each individual over the samples of the window (the newest measurements).
std::vector<double> evaluate(const SearchProblem& problem, std::span<const Genome> population,
                             std::span<const Sample> window, double bias);

/// Runs the traditional genetic algorithm over a record of measurements (thesis figure 1.1, 3.1.1), without a simulated
/// machine. The same search with slaves (algorithm A) must give the same results bit for bit. To the observer and the
/// checkpoints, the search has the name "traditional". If it continues from a checkpoint of an earlier run
/// (gaprocs/checkpoints.hpp), the estimates of the earlier run are absent. For an objective, the first estimate is then
/// the best individual of the earlier run. Throws what SearchSettings::validate(), settings_for(),
/// WindowSettings::validate_for(), require_channels() and SearchProgress throw.
SearchResult run_traditional(const SearchProblem& problem, std::span<const Sample> record,
                             const SearchSettings& settings, RandomStream random, SearchObserver* observer = nullptr,
                             Checkpoints* checkpoints = nullptr);
/// Runs the algorithm on a problem with an objective, which needs no measurements. Gives one estimate for each
/// generation.
SearchResult run_traditional(const SearchProblem& problem, std::size_t generations, const SearchSettings& settings,
                             RandomStream random, SearchObserver* observer = nullptr,
                             Checkpoints* checkpoints = nullptr);

} // namespace placedpar
