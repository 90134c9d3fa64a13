#include "experiments/kit/study_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// A farm that deals out tasks on demand. A slave may have several tasks at the same time.
struct FarmOnDemand {
    const char* name;
    int slaves, links, branches;
};

constexpr FarmOnDemand farms_on_demand[]{
    {"chain of 3", 3, 1, 1}, {"star of 3", 3, 3, 1}, {"chain of 15", 15, 1, 1}, {"tree of 15", 15, 3, 3}};

Overrides overrides_of(const FarmOnDemand& farm, int under_way) {
    return {{"slaves", fmt::format("{}", farm.slaves)},
            {"links", fmt::format("{}", farm.links)},
            {"branches", fmt::format("{}", farm.branches)},
            {"split", "demand"},
            {"tasks_under_way", fmt::format("{}", under_way)},
            {"samples", "12"},
            {"master.rehearsals", "0"}};
}

/// Adds T_sr, and the mean and the least load of the slaves' processors. This function computes the loads itself,
/// because a study's measure of the load would include the master's processor.
void add_under_way(Comparison& comparison, const StudyReplay& study, const FarmOnDemand& farm, int under_way) {
    const Overrides set = overrides_of(farm, under_way);
    double least = 100, mean = 0;
    for (int slave = 1; slave <= farm.slaves; ++slave) {
        double percent = study.measured(set, fmt::format("t[{}].busy", slave));
        least = std::min(least, percent);
        mean += percent / farm.slaves;
    }
    auto column = fmt::format("{} under way", under_way);
    auto row = [&](const char* what) { return fmt::format("{}, {}", farm.name, what); };
    comparison.add(plain_cell(row("T_sr"), column, "ms", study.measured(set, "master.T_sr"), 2));
    comparison.add(plain_cell(row("slaves busy"), column, "%", mean, 1));
    comparison.add(plain_cell(row("the least busy"), column, "%", least, 1));
}

Comparison under_way_table(const StudyReplay& study) {
    Comparison comparison{.name = "dealt out on demand: 1 to 3 unanswered tasks at each slave"};
    for (const FarmOnDemand& farm : farms_on_demand)
        for (int under_way : {1, 2, 3})
            add_under_way(comparison, study, farm, under_way);
    comparison.notes =
        "busy: share of the run in which a slave's processor works; no slave works while the master breeds\n";
    return comparison;
}

/// Plots the figures of a table against the number of slaves, with a curve for each form of the farm.
Panel farm_panel(const StudyReplay& study, const Comparison& table, const std::string& measured,
                 const std::string& title) {
    Panel panel{.title = title, .x = {.label = "slaves"}, .y = {.label = fmt::format("{} [ms]", measured), .from = 0}};
    for (const Cell& cell : table.cells) {
        auto series = std::ranges::find(panel.series, cell.column, &Series::name);
        if (series == panel.series.end())
            series = panel.series.insert(series, {.name = cell.column, .points = {}});
        // The row's name is a text such as "12 slaves", which contains the number of slaves.
        series->points.push_back({study.number_in(cell.row), cell.simulated});
    }
    return panel;
}

NamedPlot farm_plot(const StudyReplay& study, Replay& replay) {
    const Comparison &communication = study.table(replay, "C_time2: the communication of a generation"),
                     &generation = study.table(replay, "T_exe: a generation");
    Panel panel = farm_panel(study, communication, "C_time2", "communication of a generation");
    panel.series.push_back({.name = "Table E.1", .points = {{1, 0.6}, {2, 1.28}, {3, 1.89}}, .stroke = Stroke::points});
    panel.marks.push_back({.name = "appendix E: a link each", .y = 0.4});
    return {
        "farms",
        {"Forms of a farm over the number of slaves", {panel, farm_panel(study, generation, "T_exe", "a generation")}}};
}

Replay replay_farms(const ReplayContext& context) {
    const StudyReplay study(context, "genetic/farms/farms.toml");
    Replay replay = study.replay();
    replay.plots = {farm_plot(study, replay)};
    replay.comparisons.push_back(under_way_table(study));
    return replay;
}

} // namespace

extern const Experiment farms_experiment{
    .name = "farms",
    .about = "communication times with slaves in a chain, a star and trees",
    .chapter = "E",
    .number = 3,
    .run = replay_farms,
};

} // namespace placedpar
