#include "experiments/chapter_5/kit/maximisation.hpp"
#include "experiments/chapter_5/kit/plant_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/interval.hpp"
#include "identification/statistics.hpp"

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

/// Share of the runs in percent that reach the target.
double reached_percent(const std::vector<double>& generations) {
    double reached = 0;
    for (double each : generations)
        reached += each < generation_limit;
    return 100 * reached / static_cast<double>(generations.size());
}

/// Generations to the target, by the size of the islands.
struct TaskStudy {
    StaticTask task;
    std::vector<std::vector<double>> generations; ///< of local_populations, of each seed

    TaskStudy(const ReplayContext& context, const StaticTask& of) : task(of) {
        for (std::size_t population : local_populations)
            generations.push_back(
                study_task(context, task, global_population / population, population, generation_limit));
    }
};

Comparison maximisation_table(const std::vector<TaskStudy>& studies) {
    Comparison comparison{
        .name = "generations until the target is reached (500: not reached), medians, and the share of runs",
        .against = "known"};
    for (const TaskStudy& study : studies)
        for (std::size_t i = 0; i < study.generations.size(); ++i) {
            std::string row = fmt::format("{}, {}", study.task.problem, islands_of(local_populations[i]));
            comparison.add(plain_cell(row, "generations", "", identification::median(study.generations[i]), 1));
            comparison.add(plain_cell(row, "reached [%]", "", reached_percent(study.generations[i]), 0));
        }
    return comparison;
}

/// "As small as 6 without affecting the measured convergence rate": a tenth more generations at most. Of a function
/// whose target few runs reach, a median says nothing.
std::vector<Claim> maximisation_claims(const std::vector<TaskStudy>& studies) {
    std::vector<Claim> claims;
    for (const TaskStudy& study : studies)
        if (reached_percent(study.generations.front()) > 75)
            claims.push_back({study.task.problem + ": generations, islands of 6 by one of 96",
                              "",
                              ratio(study.generations.back(), study.generations.front()),
                              {},
                              1.1});
    return claims;
}

/// Islands of the same global population on the changing plant, which send in turn along a hypercube.
PlantIslands islands_on_plant(std::size_t population, double noise) {
    std::size_t islands = global_population / population;
    PlantIslands plant = sized(traditional_pga("sequential(every = 3)", noise), islands_of(population),
                               std::vector<std::size_t>(islands, population), std::vector<std::size_t>(islands, 30));
    if (islands == 1)
        plant.topology = "none";
    return plant;
}

/// "At least 20": islands of 24 follow as well as one population, and those of 6 do not.
std::vector<Claim> identification_claims(const std::vector<PlantStudy>& studies) {
    auto more_error = [&](std::size_t than, std::size_t of) {
        return less(studies[of].of(0, Tracking::error_after), studies[than].of(0, Tracking::error_after));
    };
    return {{"error after, islands of 24 less one of 96", "", more_error(0, 2), {}, 0.01},
            {"error after, islands of 6 less islands of 24", "", more_error(2, 4), 0.01, {}},
            {"lag, islands of 24 less one of 96",
             "generations",
             less(studies[2].of(0, Tracking::lag), studies[0].of(0, Tracking::lag)),
             {},
             10},
            {"lag, islands of 6 less islands of 24",
             "generations",
             less(studies[4].of(0, Tracking::lag), studies[2].of(0, Tracking::lag)),
             10,
             {}}};
}

Comparison diversity_of(const std::vector<PlantStudy>& studies, const std::string& noise) {
    Comparison comparison{.name = "medians of the first island, " + noise, .against = "known"};
    for (const PlantStudy& study : studies) {
        auto add = [&](const char* column, double value, int decimals) {
            comparison.add(plain_cell(study.islands.name, column, "", value, decimals));
        };
        add("diversity [bits of 37]", identification::median(study.diversity), 2);
        add("lag", study.median(0, Tracking::lag), 1);
        add("error before", study.median(0, Tracking::error_before), 3);
        add("error after", study.median(0, Tracking::error_after), 3);
        add("found [%]", study.found_percent(0), 0);
    }
    return comparison;
}

/// Known: the same with 240 other seeds.
Comparison judged_sizes(const std::vector<TaskStudy>& tasks) {
    Comparison comparison{.name = "one-max of 60 bits, generations to all ones", .against = "known"};
    const double known[]{31, 31, 33, 36, 45};
    for (std::size_t i = 0; i < std::size(known); ++i)
        comparison.add(judged_cell(islands_of(local_populations[i]), "median", "generations", known[i],
                                   identification::median(tasks.front().generations[i]), 5, 1));
    return comparison;
}

Panel task_panel(const std::vector<TaskStudy>& studies) {
    Panel panel{.title = "functions that stand still: generations to the target",
                .x = {"individuals of an island, of 96 in all", 0, 100},
                .y = {"generations (500: not reached)", 0, 510}};
    int colour = 0;
    for (const TaskStudy& study : studies) {
        Series medians{.name = study.task.problem, .colour = colour};
        for (std::size_t i = 0; i < study.generations.size(); ++i) {
            auto x = static_cast<double>(local_populations[i]) + 0.4 * colour;
            Interval interval = median_interval(study.generations[i]);
            medians.points.push_back({x, identification::median(study.generations[i])});
            panel.series.push_back({.name = "", .points = {{x, interval.low}, {x, interval.high}}, .colour = colour});
        }
        panel.series.push_back(std::move(medians));
        ++colour;
    }
    return panel;
}

Replay replay_local_population(const ReplayContext& context) {
    std::vector<TaskStudy> tasks;
    for (const StaticTask& task : static_tasks())
        tasks.emplace_back(context, task);
    std::vector<Comparison> comparisons{
        judged_sizes(tasks), maximisation_table(tasks),
        claims_comparison("claims, functions that stand still", maximisation_claims(tasks))};
    Plot plot{"How small may an island be? " + median_of_seeds(context), {task_panel(tasks)}};
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
    .about = "how small an island may be, in maximisation and in identification (5.2.1)",
    .chapter = "5",
    .number = 8,
    .run = replay_local_population,
    .seeds = plant_seeds,
};

} // namespace placedpar
