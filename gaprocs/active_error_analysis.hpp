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

/// Returns the errors of each individual at each sample of the longest window. REQUIRES: a window for each individual,
/// and at least as many samples as the longest window has.
ErrorsOfBest errors_of_best(const SearchProblem& problem, std::span<const Individual> bests,
                            std::span<const std::size_t> windows, std::span<const Sample> samples);

/// Chooses one answer among the bests of several islands, each time they have broadcast them, and keeps it in between
/// (thesis 5.3.2: "output the estimated parameters at the broadcasting frequency"). The islands are not affected.
class ActiveErrorAnalysis {
public:
    /// `windows`: the length of each island's window, in samples. `problem` must outlive this.
    ActiveErrorAnalysis(const SearchProblem& problem, std::vector<std::size_t> windows, IslandChoice choice,
                        RandomStream random);

    /// `bests`: the best of each island; `samples`: the newest last, at least the longest window.
    /// Throws as the choice. REQUIRES: a best for each window.
    void analyse(std::span<const Individual> bests, std::span<const Sample> samples);

    /// Returns the island whose best is the answer since the last analyse(). REQUIRES: analyse() was called.
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
