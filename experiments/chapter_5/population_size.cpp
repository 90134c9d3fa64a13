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

constexpr std::size_t population_sizes[]{25, 50, 100, 200, 400, 800};
constexpr std::size_t evaluation_limit = 80000;

/// Finds the number of evaluations until the target is reached, for each size of the population.
TaskStudy study_populations(const ReplayContext& context, const StaticTask& task) {
    TaskStudy study{task, {std::begin(population_sizes), std::end(population_sizes)}, evaluation_limit, {}};
    for (std::size_t population : population_sizes) {
        study.taken.push_back(study_task(context, task, 1, population, evaluation_limit / population));
        for (double& each : study.taken.back())
            each *= static_cast<double>(population);
    }
    return study;
}

/// Tests the claim "The global population size plays a significant role", taken to mean "400 individuals need at least
/// a fifth more evaluations than 100". Functions whose target only few runs reach are left out, because their medians
/// have no meaning.
std::vector<Claim> size_claims(const std::vector<TaskStudy>& studies) {
    std::vector<Claim> claims;
    for (const TaskStudy& study : studies)
        if (study.reached_percent(2) > 75)
            claims.push_back({study.task.problem + ": evaluations, 400 / 100 individuals",
                              "",
                              ratio(study.taken[4], study.taken[2]),
                              1.2,
                              {}});
    return claims;
}

std::string individuals(std::size_t population) { return fmt::format("{} individuals", population); }

PlantIslands one_population(std::size_t population, double noise) {
    return sized(single_ga(noise), individuals(population), {population}, {30});
}

/// Tests the claim "Good performance can be obtained from small global population size of 100". The claim is taken to
/// mean that 100 individuals find the pole, and that 400 individuals reduce the lag by at most ten generations and the
/// error by at most .01.
std::vector<Claim> plant_claims(const std::vector<PlantStudy>& studies) {
    return {{"error after, 100 individuals", "", studies[2].errors_after(), {}, found_pole},
            {"lag, 100 minus 400 individuals", "generations", less(studies[2].lags(), studies[4].lags()), {}, 10},
            {"error after, 100 minus 400 individuals",
             "",
             less(studies[2].errors_after(), studies[4].errors_after()),
             {},
             0.01},
            {"lag, 25 minus 100 individuals", "generations", less(studies[0].lags(), studies[2].lags()), 10, {}}};
}

/// Compares the median lags with the medians over 240 other seeds.
Comparison judged_lags(const std::vector<PlantStudy>& noiseless) {
    Comparison comparison{.name = "lag on the plant, noiseless", .against = "known"};
    const double known[]{106, 90, 84, 82, 81, 80};
    for (std::size_t i = 0; i < std::size(known); ++i)
        comparison.add(judged_cell(noiseless[i].islands.name, "median", "generations", known[i],
                                   noiseless[i].median(0, Tracking::lag), 10, 1));
    return comparison;
}

Replay replay_population_size(const ReplayContext& context) {
    std::vector<TaskStudy> tasks;
    for (const StaticTask& task : static_tasks())
        tasks.push_back(study_populations(context, task));
    std::vector<Comparison> comparisons(1);
    Plot plot{"How large a population? " + median_of_seeds(context), {}};
    const Axis sizes{"individuals", 0, 850};
    plot.panels.push_back(
        taken_panel("functions that stand still", sizes, {"evaluations to the target", 0, 20000}, tasks));
    plot.panels.push_back(reached_panel("functions that stand still", sizes, tasks));
    for (double noise : {0.0, 0.3}) {
        std::vector<PlantStudy> studies;
        for (std::size_t population : population_sizes)
            studies.push_back(study_plant(context, one_population(population, noise)));
        if (noise == 0)
            comparisons.front() = judged_lags(studies);
        comparisons.push_back(tracks_comparison("medians on the plant, " + noise_name(noise), study_rows(studies)));
        comparisons.push_back(claims_comparison("claims, identification, " + noise_name(noise), plant_claims(studies)));
        plot.panels.push_back(pole_panel("the plant, " + noise_name(noise), study_rows(studies)));
    }
    comparisons.push_back(
        tasks_comparison("evaluations until the target is reached (80000: not reached), medians, and the share of runs",
                         tasks, "evaluations", 0, individuals));
    comparisons.push_back(claims_comparison("claims, functions that do not change", size_claims(tasks)));
    return replay_of(std::move(comparisons), {{"population-size", plot}});
}

} // namespace

extern const Experiment population_size_experiment{
    .name = "population-size",
    .about = "how large a population should be for maximisation and for identification (5.2.1)",
    .chapter = "5",
    .number = 7,
    .run = replay_population_size,
    .seeds = plant_seeds,
};

} // namespace placedpar
