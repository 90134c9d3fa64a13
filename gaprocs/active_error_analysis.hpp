#pragma once

#include "gaprocs/policies/individual.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// Returns the errors of each island's best individual. IslandChoice, the rule that picks one island, compares these
/// errors. `windows`: for each island, the number of newest samples over which it evaluates its individuals. REQUIRES:
/// bests.size() == windows.size() > 0, and no window is longer than `samples`.
ErrorsOfBest errors_of_best(const SearchProblem& problem, std::span<const Individual> bests,
                            std::span<const std::size_t> windows, std::span<const Sample> samples);

/// Gives one answer for several islands whose windows (the newest samples of the measurements) have different lengths.
/// Whenever the islands broadcast their best individuals, it chooses one of these individuals as the answer. The answer
/// stays until the next broadcast (thesis 5.3.2: "output the estimated parameters at the broadcasting frequency"). The
/// choice does not change the islands.
class ActiveErrorAnalysis {
public:
    /// `windows`: the length of each island's window in samples. REQUIRES: `problem` outlives the analysis.
    ActiveErrorAnalysis(const SearchProblem& problem, std::vector<std::size_t> windows, IslandChoice choice,
                        RandomStream random);

    /// Chooses the answer. `bests`: the best individual of each island. `samples`: the samples so far, oldest first.
    /// Throws what the IslandChoice throws. REQUIRES: bests.size() is the number of islands, and no window is longer
    /// than `samples`.
    void analyse(std::span<const Individual> bests, std::span<const Sample> samples);

    /// Returns the island that the last analyse() chose. REQUIRES: analyse() was called.
    std::size_t island() const { return island_; }
    const Individual& answer() const { return *answer_; }

private:
    const SearchProblem& problem_;
    std::vector<std::size_t> windows_;
    IslandChoice choice_;
    RandomStream random_;
    std::size_t island_ = 0;
    std::optional<Individual> answer_;
};

} // namespace placedpar
