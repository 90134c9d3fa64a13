#include "gaprocs/traditional.hpp"

#include "gaprocs/search_progress.hpp"
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
                             RandomStream random, SearchObserver* observer, Checkpoints* checkpoints) {
    SearchSettings settings = settings_for(problem, wanted);
    settings.window.validate_for(record.size());
    require_channels(problem, record);
    Search search(problem.representation(), settings, std::move(random));
    if (observer)
        search.listen(told_to(*observer, "traditional", problem));
    SearchProgress progress(search, "traditional", checkpoints);
    SlidingWindow window(settings.window);
    SearchResult result;
    add_earlier_best(result, problem, progress, search);
    for (std::size_t i = 0; i < record.size(); ++i) {
        window.push(record[i]);
        if (!window.ready())
            continue;
        const std::uint64_t before = search.generation();
        for (std::size_t trial = 0; trial < settings.window.trials; ++trial) {
            if (progress.passes_over())
                continue;
            progress.note_population(search);
            search.next_generation(evaluate(problem, search.population(), window.samples(), settings.window.bias));
            progress.note_best(search);
            progress.keep(search);
        }
        if (search.generation() > before)
            result.estimates.push_back({i, search.best(), problem.decode(search.best().genome)});
    }
    progress.require_passed(search);
    result.generations = search.generation();
    result.redraws = search.redraws();
    result.population = search.population();
    return result;
}

SearchResult run_traditional(const SearchProblem& problem, std::size_t generations, const SearchSettings& settings,
                             RandomStream random, SearchObserver* observer, Checkpoints* checkpoints) {
    return run_traditional(problem, empty_record(generations), settings, std::move(random), observer, checkpoints);
}

void add_earlier_best(SearchResult& result, const SearchProblem& problem, const SearchProgress& progress,
                      const Search& search) {
    if (progress.best() && problem.objective())
        result.estimates.push_back({static_cast<std::size_t>(search.generation() - 1), *progress.best(),
                                    problem.decode(progress.best()->genome)});
}

const Estimate& SearchResult::best() const {
    auto fitness = [](const Estimate& estimate) { return estimate.best.fitness; };
    auto best = std::ranges::max_element(estimates, {}, fitness);
    if (best == estimates.end())
        throw std::logic_error("no generation has been evaluated, so there is no best individual");
    return *best;
}

} // namespace placedpar
