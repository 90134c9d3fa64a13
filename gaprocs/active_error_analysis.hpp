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

/// The errors of each individual at each of the newest samples of the longest window. REQUIRES: a window for each
/// individual, as many samples as the longest of them.
ErrorsOfBest errors_of_best(const SearchProblem& problem, std::span<const Individual> bests,
                            std::span<const std::size_t> windows, std::span<const Sample> samples);

/// The one answer of several islands, over time: analysed each time they have broadcast their bests, held in between
/// (thesis 5.3.2: "output the estimated parameters at the broadcasting frequency"). It changes nothing on the islands.
class ActiveErrorAnalysis {
public:
    /// The windows of the islands, in samples. `problem` must outlive this.
    ActiveErrorAnalysis(const SearchProblem& problem, std::vector<std::size_t> windows, IslandChoice choice,
                        RandomStream random);

    /// `bests`: the best of each island; `samples`: the newest last, at least the longest window.
    /// Throws as the choice. REQUIRES: a best for each window.
    void analyse(std::span<const Individual> bests, std::span<const Sample> samples);

    /// Whose best is the answer since the last analyse(). REQUIRES: there was one.
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
