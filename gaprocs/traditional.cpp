#include "gaprocs/traditional.hpp"

#include "gaprocs/usual_settings.hpp"
#include "gaprocs/window.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar {

std::vector<double> evaluate(const SearchProblem& problem, std::span<const Genome> population,
                             std::span<const Sample> window, double bias) {
    std::vector<double> fitness(population.size());
    problem.fitness_of(population, window, bias, fitness);
    return fitness;
}

SearchResult run_traditional(const SearchProblem& problem, std::span<const Sample> record, const SearchSettings& wanted,
                             RandomStream random, SearchObserver* observer) {
    SearchSettings settings = settings_for(problem, wanted);
    settings.window.validate_for(record.size());
    require_channels(problem, record);
    Search search(problem.representation(), settings, std::move(random));
    if (observer)
        search.listen(told_to(*observer, "traditional", problem));
    SlidingWindow window(settings.window);
    SearchResult result;
    for (std::size_t i = 0; i < record.size(); ++i) {
        window.push(record[i]);
        if (!window.ready())
            continue;
        for (std::size_t trial = 0; trial < settings.window.trials; ++trial)
            search.next_generation(evaluate(problem, search.population(), window.samples(), settings.window.bias));
        result.estimates.push_back({i, search.best(), problem.decode(search.best().genome)});
    }
    result.generations = search.generation();
    result.redraws = search.redraws();
    result.population = search.population();
    return result;
}

SearchResult run_traditional(const SearchProblem& problem, std::size_t generations, const SearchSettings& settings,
                             RandomStream random, SearchObserver* observer) {
    return run_traditional(problem, empty_record(generations), settings, std::move(random), observer);
}

const Estimate& SearchResult::best() const {
    auto fitness = [](const Estimate& estimate) { return estimate.best.fitness; };
    auto best = std::ranges::max_element(estimates, {}, fitness);
    if (best == estimates.end())
        throw std::logic_error("no generation has been evaluated, so there is no best individual");
    return *best;
}

} // namespace placedpar
