#include "experiments/chapter_5/kit/maximisation.hpp"
#include "experiments/chapter_5/kit/plant_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "text/interval.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t global_population = 96, generation_limit = 500;
constexpr std::size_t local_populations[]{96, 48, 24, 12, 6};

std::string islands_of(std::size_t population) {
    return population == global_population
               ? fmt::format("one of {}", population)
               : fmt::format("{} islands of {}", global_population / population, population);
}

/// Finds the number of generations until the target is reached, for each size of the islands.
TaskStudy study_islands(const ReplayContext& context, const StaticTask& task) {
    TaskStudy study{task, {std::begin(local_populations), std::end(local_populations)}, generation_limit, {}};
    for (std::size_t population : local_populations)
        study.taken.push_back(study_task(context, task, global_population / population, population, generation_limit));
    return study;
}

/// Tests the claim "as small as 6 without affecting the measured convergence rate", taken to mean "islands of 6 need at
/// most a tenth more generations than one population". Functions whose target only few runs reach are left out, because
/// their medians have no meaning.
std::vector<Claim> maximisation_claims(const std::vector<TaskStudy>& studies) {
    std::vector<Claim> claims;
    for (const TaskStudy& study : studies)
        if (study.reached_percent(0) > 75)
            claims.push_back({study.task.problem + ": generations, islands of 6 / one of 96",
                              "",
                              ratio(study.taken.back(), study.taken.front()),
                              {},
                              1.1,
                              ClaimVerdict::fails});
    return claims;
}

/// Returns the settings of islands on the changing plant, with the usual global population. At each exchange, an island
/// sends to one of its neighbours in a hypercube.
PlantIslands islands_on_plant(std::size_t population, double noise) {
    std::size_t islands = global_population / population;
    PlantIslands plant = sized(traditional_pga("sequential(every = 3)", noise), islands_of(population),
                               std::vector<std::size_t>(islands, population), std::vector<std::size_t>(islands, 30));
    if (islands == 1)
        plant.topology = "none";
    return plant;
}

/// Tests the claim "at least 20", taken to mean "islands of 24 follow as well as one population, and islands of 6 do
/// not".
std::vector<Claim> identification_claims(const std::vector<PlantStudy>& studies) {
    auto more_error = [&](std::size_t than, std::size_t of) {
        return less(studies[of].errors_after(), studies[than].errors_after());
    };
    return {
        {"error after, islands of 24 minus one of 96", "", more_error(0, 2), {}, 0.01},
        {"error after, islands of 6 minus islands of 24", "", more_error(2, 4), 0.01, {}},
        {"lag, islands of 24 minus one of 96", "generations", less(studies[2].lags(), studies[0].lags()), {}, 10},
        {"lag, islands of 6 minus islands of 24", "generations", less(studies[4].lags(), studies[2].lags()), 10, {}}};
}

Comparison diversity_of(const std::vector<PlantStudy>& studies, const std::string& noise) {
    Comparison comparison{.name = "medians of the first island, " + noise, .against = "known"};
    for (const PlantStudy& study : studies) {
        auto add = [&](const char* column, double value, int decimals) {
            comparison.add(plain_cell(study.islands.name, column, "", value, decimals));
        };
        add("diversity [bits of 37]", median(study.diversity), 2);
        add("lag", study.median(0, Tracking::lag), 1);
        add("error before", study.median(0, Tracking::error_before), 3);
        add("error after", study.median(0, Tracking::error_after), 3);
        add("found [%]", study.found_percent(0), 0);
    }
    return comparison;
}

/// Compares the median numbers of generations with the medians over 240 other seeds.
Comparison judged_sizes(const std::vector<TaskStudy>& tasks) {
    Comparison comparison{.name = "one-max of 60 bits, generations to all ones", .against = "known"};
    const double known[]{31, 31, 33, 36, 45};
    for (std::size_t i = 0; i < std::size(known); ++i)
        comparison.add(judged_cell(islands_of(local_populations[i]), "median", "generations", known[i],
                                   tasks.front().median(i), 5, 1));
    return comparison;
}

/// Plots the best objective of one-max over the generations, for islands of three sizes.
Panel climb_panel(const ReplayContext& context) {
    const StaticTask& task = static_tasks().front();
    std::vector<ConvergenceCurve> curves;
    for (std::size_t population : {96u, 24u, 6u}) {
        curves.push_back(study_convergence(context, task, global_population / population, population, 60));
        curves.back().name = islands_of(population);
        curves.back().colour = static_cast<int>(curves.size()) - 1;
    }
    return convergence_panel(task.problem + ", the best so far, medians and quartiles", "ones", curves);
}

Replay replay_local_population(const ReplayContext& context) {
    std::vector<TaskStudy> tasks;
    for (const StaticTask& task : static_tasks())
        tasks.push_back(study_islands(context, task));
    std::vector<Comparison> comparisons{
        judged_sizes(tasks),
        tasks_comparison("generations until the target is reached (500: not reached), medians, and the share of runs",
                         tasks, "generations", 1, islands_of),
        claims_comparison("claims, functions that do not change", maximisation_claims(tasks))};
    Plot plot{"How small may an island be? " + median_of_seeds(context), {}};
    const Axis sizes{"individuals of an island, of 96 in all", 0, 100};
    plot.panels.push_back(
        taken_panel("functions that stand still", sizes, {"generations to the target", 0, 55}, tasks));
    plot.panels.push_back(reached_panel("functions that stand still", sizes, tasks));
    plot.panels.push_back(climb_panel(context));
    for (double noise : {0.0, 0.3}) {
        std::vector<PlantStudy> studies;
        for (std::size_t population : local_populations)
            studies.push_back(study_plant(context, islands_on_plant(population, noise)));
        comparisons.push_back(diversity_of(studies, noise_name(noise)));
        comparisons.push_back(
            claims_comparison("claims, identification, " + noise_name(noise), identification_claims(studies)));
        plot.panels.push_back(
            pole_panel("the plant, " + noise_name(noise),
                       {{islands_of(96), &studies[0]}, {islands_of(24), &studies[2]}, {islands_of(6), &studies[4]}}));
    }
    return replay_of(std::move(comparisons), {{"local-population", plot}});
}

} // namespace

extern const Experiment local_population_experiment{
    .name = "local-population",
    .about = "how small an island may be for maximisation and for identification (5.2.1)",
    .chapter = "5",
    .number = 8,
    .run = replay_local_population,
    .seeds = plant_seeds,
};

} // namespace placedpar
