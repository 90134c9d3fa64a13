#include "gaprocs/search_observer.hpp"

#include "gaprocs/search_problem.hpp"

#include <utility>

namespace placedpar {

Search::Listener told_to(SearchObserver& observer, std::string search, const SearchProblem& problem, Time (*now)()) {
    auto objective = problem.objective();
    auto goal = objective ? std::optional(objective->goal) : std::nullopt;
    return [&observer, name = std::move(search), goal, now](const Search& each, std::span<const double> fitness) {
        auto time = now ? std::optional(now()) : std::nullopt;
        observer.observe({name, each.generation() + 1, time, each.representation(), each.population(), fitness, goal});
    };
}

} // namespace placedpar
