#include "experiments/chapter_6/kit/conditions.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace placedpar {

namespace {

struct CrossingTried {
    const char *name, *crossover;
    double probability = 0.8;
};

constexpr CrossingTried crossings[]{
    {.name = "one-point, .8", .crossover = "one-point"},
    {.name = "by difference, .8", .crossover = "by-difference"},
    {.name = "one-point, always", .crossover = "one-point", .probability = 1},
    {.name = "two-point, .8", .crossover = "two-point"},
    {.name = "uniform, .8", .crossover = "uniform"},
    {.name = "none", .crossover = "one-point", .probability = 0},
};

struct CrossingGroup {
    std::size_t field_bits, population;
    Expected one_point, by_difference;
};

constexpr CrossingGroup crossing_groups[]{
    {.field_bits = 4, .population = 24, .one_point = {90, 38}, .by_difference = {93, 49}},
    {.field_bits = 7, .population = 30, .one_point = {99, 66}, .by_difference = {97, 70}},
    {.field_bits = 7, .population = 100, .one_point = {100, 88}, .by_difference = {}},
};

std::string name_of_group(const CrossingGroup& group) {
    return fmt::format("{} bits, {} individuals", plant_reading(group.field_bits).length(), group.population);
}

PlantSearch search_of(const CrossingGroup& group, const CrossingTried& tried) {
    PlantSearch search{plant_settings(group.population), plant_reading(group.field_bits)};
    search.settings.crossover = Crossover::named(tried.crossover);
    search.settings.crossover_probability = tried.probability;
    return search;
}

ConditionGroup compare_crossings(const CrossingGroup& group, const ReplayContext& context) {
    std::vector<Condition> conditions;
    for (const CrossingTried& tried : crossings)
        conditions.push_back({tried.name, search_of(group, tried)});
    conditions[0].expected = group.one_point;
    conditions[1].expected = group.by_difference;
    return compare_conditions(context, name_of_group(group), "one-point crossover", conditions);
}

Panel crossing_panel(const Comparison& shares) {
    Panel panel{.title = shares.name,
                .x = {"generation of convergence, median", 0, std::nullopt},
                .y = {"runs that followed [%]", 0, 105}};
    for (std::size_t i = 0; i < std::size(crossings); ++i) {
        std::string row = crossings[i].name;
        auto figure = [&](const char* column) { return figure_in(shares, row, column); };
        double x = figure("generation"), y = figure("followed");
        panel.series.push_back({.name = row,
                                .points = {{x, y}},
                                .stroke = Stroke::points,
                                .intervals = {{figure("followed >="), figure("followed <=")}},
                                .x_intervals = {{figure("generation >="), figure("generation <=")}}});
    }
    return panel;
}

Replay replay_crossover_by_difference(const ReplayContext& context) {
    std::vector<Comparison> comparisons;
    Plot plot{"Crossover operators: how soon and how often they find the plant, with 95 % intervals", {}};
    for (const CrossingGroup& group : crossing_groups) {
        ConditionGroup compared = compare_crossings(group, context);
        plot.panels.push_back(crossing_panel(compared.shares));
        comparisons.push_back(std::move(compared.shares));
        comparisons.push_back(std::move(compared.gains));
    }
    return replay_of(std::move(comparisons), {{"crossover-by-difference", plot}});
}

} // namespace

extern const Experiment crossover_by_difference_experiment{
    .name = "crossover-by-difference",
    .about =
        "crossover of mates chosen by their bit difference, compared with other operators, on the plant of chapter 5",
    .chapter = "6",
    .number = 5,
    .run = replay_crossover_by_difference,
    .seeds = 100,
};

} // namespace placedpar
