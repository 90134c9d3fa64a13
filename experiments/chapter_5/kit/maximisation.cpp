#include "experiments/chapter_5/kit/maximisation.hpp"

#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "gaprocs/generation_log.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/usual_settings.hpp"
#include "problems/benchmark/benchmark.hpp"
#include "text/interval.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

const SearchProblem& static_problem(const std::string& name) {
    static const ProblemRegistry registry = [] {
        ProblemRegistry problems;
        add_benchmark_problems(problems);
        for (const StaticTask& task : static_tasks())
            problems.find(task.problem); // made here, before threads use the problem
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

IslandsResult run_hypercube(const SearchProblem& problem, std::size_t islands, std::size_t population,
                            std::size_t generations, std::uint64_t seed, SearchObserver* observer = nullptr) {
    return run_islands(problem, generations, hypercube(problem, islands, population), island_streams(seed, islands),
                       observer);
}

/// Returns the best objective of all islands in each generation.
Figures best_so_far(const SearchProblem& problem, std::size_t islands, std::size_t population, std::size_t generations,
                    std::uint64_t seed) {
    GenerationLog log(island_names(islands));
    run_hypercube(problem, islands, population, generations, seed, &log);
    Figures best;
    for (const LoggedGeneration& each : log.compares() ? log.of_all() : log.of(0))
        best.push_back(each.best_so_far);
    return best;
}

double best_fitness(const IslandsResult& result, std::size_t generation) {
    double best = result.islands.front().estimates[generation].best.fitness;
    for (const SearchResult& island : result.islands)
        best = std::max(best, island.estimates[generation].best.fitness);
    return best;
}

/// Calls `add(series, study, size, x)` for each size of each study, where `size` is an index.
template <class Add>
Panel panel_by_size(Panel panel, const std::vector<TaskStudy>& studies, Add add) {
    int colour = 0;
    for (const TaskStudy& study : studies) {
        Series series{.name = study.task.problem, .colour = colour++};
        for (std::size_t i = 0; i < study.sizes.size(); ++i)
            add(series, study, i, static_cast<double>(study.sizes[i]));
        if (!series.points.empty())
            panel.series.push_back(std::move(series));
    }
    return panel;
}

} // namespace

const std::vector<StaticTask>& static_tasks() {
    static const std::vector<StaticTask> tasks{
        {"one-max(bits = 60)", 60},                   // every bit is 1
        {"foxholes", 1},                              // the deepest of the holes, .998
        {"schwefel(dimensions = 5, bits = 10)", 100}, // in the basin of the optimum; the next minimum is 118
        {"trap(blocks = 6, size = 4)", 24}};          // outside every trap
    return tasks;
}

std::size_t generations_to_target(const StaticTask& task, std::size_t islands, std::size_t population,
                                  std::size_t limit, std::uint64_t seed) {
    const SearchProblem& problem = static_problem(task.problem);
    auto result = run_hypercube(problem, islands, population, limit, seed);
    double target = problem.objective()->fitness(task.target);
    for (std::size_t generation = 0; generation < limit; ++generation)
        if (best_fitness(result, generation) >= target)
            return generation + 1;
    return limit;
}

std::size_t TaskStudy::reached(std::size_t size) const {
    return static_cast<std::size_t>(std::ranges::count_if(taken[size], [&](double each) { return each < limit; }));
}

double TaskStudy::reached_percent(std::size_t size) const {
    return 100 * static_cast<double>(reached(size)) / static_cast<double>(taken[size].size());
}

double TaskStudy::median(std::size_t size) const { return placedpar::median(taken[size]); }

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

ConvergenceCurve study_convergence(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                                   std::size_t population, std::size_t generations) {
    const SearchProblem& problem = static_problem(task.problem);
    std::string what = fmt::format("{}, {} islands of {}, best so far, {} generations", task.problem, islands,
                                   population, generations);
    auto runs = run_seeds(context, what, [&](std::uint64_t seed) {
        return best_so_far(problem, islands, population, generations, seed);
    });
    return {.name = {}, .runs = std::move(runs), .colour = 0};
}

Comparison tasks_comparison(std::string name, const std::vector<TaskStudy>& studies, const char* column, int decimals,
                            const std::function<std::string(std::size_t)>& name_of_size) {
    Comparison comparison{.name = std::move(name), .against = "known"};
    for (const TaskStudy& study : studies)
        for (std::size_t i = 0; i < study.sizes.size(); ++i) {
            std::string row = fmt::format("{}, {}", study.task.problem, name_of_size(study.sizes[i]));
            comparison.add(plain_cell(row, column, "", study.median(i), decimals));
            comparison.add(plain_cell(row, "reached [%]", "", study.reached_percent(i), 0));
        }
    return comparison;
}

Panel taken_panel(std::string title, Axis x, Axis y, const std::vector<TaskStudy>& studies) {
    Panel panel{.title = std::move(title), .x = std::move(x), .y = std::move(y)};
    return panel_by_size(std::move(panel), studies,
                         [](Series& series, const TaskStudy& study, std::size_t size, double at) {
                             if (study.reached_percent(size) <= 90)
                                 return;
                             series.points.push_back({at, study.median(size)});
                             series.intervals.push_back(median_interval(study.taken[size]));
                         });
}

Panel reached_panel(std::string title, Axis x, const std::vector<TaskStudy>& studies) {
    Panel panel{.title = std::move(title), .x = std::move(x), .y = {"runs that reach the target [%]", 0, 105}};
    return panel_by_size(
        std::move(panel), studies, [](Series& series, const TaskStudy& study, std::size_t size, double at) {
            series.points.push_back({at, study.reached_percent(size)});
            series.intervals.push_back(success_interval(study.reached(size), study.taken[size].size()));
        });
}

} // namespace placedpar
