#include "gaprocs/active_error_analysis.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

ErrorsOfBest errors_of_best(const SearchProblem& problem, std::span<const Individual> bests,
                            std::span<const std::size_t> windows, std::span<const Sample> samples) {
    ErrorsOfBest result{{windows.begin(), windows.end()}, {}};
    std::span<const Sample> newest = samples.last(*std::ranges::max_element(windows));
    for (const Individual& best : bests) {
        std::vector<double>& errors = result.errors.emplace_back();
        for (const Sample& sample : newest)
            errors.push_back(problem.error(best.genome, sample));
    }
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
