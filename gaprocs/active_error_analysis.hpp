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

/// Returns the errors of the best individual of each island at each sample of the longest window. REQUIRES: the number
/// of windows equals the number of individuals, and `samples` are enough for the longest window.
ErrorsOfBest errors_of_best(const SearchProblem& problem, std::span<const Individual> bests,
                            std::span<const std::size_t> windows, std::span<const Sample> samples);

/// Chooses one answer among the best individuals of several islands when the islands broadcast them. Keeps the answer
/// until the next broadcast (thesis 5.3.2: "output the estimated parameters at the broadcasting frequency"). The
/// islands do not change.
class ActiveErrorAnalysis {
public:
    /// `windows`: the length of each island's window, in samples. REQUIRES: `problem` outlives the analysis.
    ActiveErrorAnalysis(const SearchProblem& problem, std::vector<std::size_t> windows, IslandChoice choice,
                        RandomStream random);

    /// Chooses the answer. `bests`: the best individual of each island. `samples`: the samples of the record so far,
    /// the newest last. Throws as the choice. REQUIRES: one best for each window, and enough samples for the longest
    /// window.
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
