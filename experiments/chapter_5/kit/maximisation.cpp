#include "experiments/chapter_5/kit/maximisation.hpp"

#include "experiments/kit/seed_runs.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/usual_settings.hpp"
#include "problems/benchmark/benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

const SearchProblem& static_problem(const std::string& name) {
    static const ProblemRegistry registry = [] {
        ProblemRegistry problems;
        add_benchmark_problems(problems);
        for (const StaticTask& task : static_tasks())
            problems.find(task.problem); // made before threads ask for it
        return problems;
    }();
    return *registry.find(name).problem();
}

IslandsSettings hypercube(const SearchProblem& problem, std::size_t islands, std::size_t population) {
    SearchSettings island = usual_settings(problem);
    island.population = population;
    island.elite = 1;
    IslandsSettings settings;
    settings.islands.assign(islands, island);
    settings.topology = Topology::named(islands == 1 ? "none" : "hypercube");
    settings.schedule = Schedule::named("sequential(every = 3)");
    settings.acceptance = Acceptance::named("offspring");
    return settings;
}

double best_fitness(const IslandsResult& result, std::size_t generation) {
    double best = result.islands.front().estimates[generation].best.fitness;
    for (const SearchResult& island : result.islands)
        best = std::max(best, island.estimates[generation].best.fitness);
    return best;
}

} // namespace

const std::vector<StaticTask>& static_tasks() {
    static const std::vector<StaticTask> tasks{
        {"one-max(bits = 60)", 60},                   // every bit
        {"foxholes", 1},                              // the deepest of the holes, .998
        {"schwefel(dimensions = 5, bits = 10)", 100}, // the best valley, the next one is 118 above it
        {"trap(blocks = 6, size = 4)", 24}};          // out of every trap
    return tasks;
}

std::size_t generations_to_target(const StaticTask& task, std::size_t islands, std::size_t population,
                                  std::size_t limit, std::uint64_t seed) {
    const SearchProblem& problem = static_problem(task.problem);
    auto result = run_islands(problem, limit, hypercube(problem, islands, population), island_streams(seed, islands));
    double target = problem.objective()->fitness(task.target);
    for (std::size_t generation = 0; generation < limit; ++generation)
        if (best_fitness(result, generation) >= target)
            return generation + 1;
    return limit;
}

std::vector<double> study_task(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                               std::size_t population, std::size_t limit) {
    std::string what = fmt::format("{}, {} islands of {}, {} generations", task.problem, islands, population, limit);
    return column(run_seeds(context, what,
                            [&](std::uint64_t seed) {
                                return Figures{
                                    static_cast<double>(generations_to_target(task, islands, population, limit, seed))};
                            }),
                  0);
}

} // namespace placedpar
