#include "gaprocs/active_error_analysis.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

/// Returns the errors of each individual of `bests` at the samples of a window.
std::vector<std::vector<double>> errors_in(const SearchProblem& problem, std::span<const Individual> bests,
                                           std::span<const Sample> window) {
    std::vector<std::vector<double>> errors;
    for (const Individual& best : bests)
        errors.push_back(problem.errors(best.genome, window));
    return errors;
}

} // namespace

ErrorsOfBest errors_of_best(const SearchProblem& problem, std::span<const Individual> bests,
                            std::span<const std::size_t> windows, std::span<const Sample> samples) {
    std::size_t longest = *std::ranges::max_element(windows);
    ErrorsOfBest result{{windows.begin(), windows.end()}, errors_in(problem, bests, samples.last(longest))};
    if (problem.depends_on_window())
        for (std::size_t window : windows)
            result.by_window.push_back(errors_in(problem, bests, samples.last(window)));
    return result;
}

ActiveErrorAnalysis::ActiveErrorAnalysis(const SearchProblem& problem, std::vector<std::size_t> windows,
                                         IslandChoice choice, RandomStream random)
    : problem_(problem), windows_(std::move(windows)), choice_(std::move(choice)), random_(std::move(random)) {}

void ActiveErrorAnalysis::analyse(std::span<const Individual> bests, std::span<const Sample> samples) {
    island_ = choice_(errors_of_best(problem_, bests, windows_, samples), random_);
    answer_ = bests[island_];
}

} // namespace placedpar
