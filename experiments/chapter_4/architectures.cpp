#include "experiments/chapter_4/kit/speedup_formulas.hpp"
#include "experiments/kit/study_replay.hpp"
#include "runtime/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace placedpar {

namespace {

constexpr std::array machine_alphas{8, 16, 24};
/// The number of islands of the largest hypercube, and of the hybrid, whose islands have slaves. With enough
/// processors, the hybrid should be faster than this hypercube.
constexpr int most_islands = 16, hybrid_islands = 4;

std::string alpha_column(int alpha) { return fmt::format("alpha = {}", alpha); }

/// Returns the speedups of one architecture over the number of processors. Throws UserError if the table has no speedup
/// of this architecture.
std::vector<Point> speedups_of(const std::string& architecture, int alpha, const StudyReplay& study,
                               const Comparison& table) {
    std::vector<Point> points;
    for (const Cell& cell : table.cells)
        if (cell.column == alpha_column(alpha) && cell.row.starts_with(architecture + ", "))
            points.push_back({study.number_in(cell.row), cell.simulated});
    if (points.empty())
        study.refuse(fmt::format("the table \"{}\" has no row \"{}, ... processors\" with a column \"{}\"", table.name,
                                 architecture, alpha_column(alpha)));
    return points;
}

/// Returns the least number of processors, above `most_islands`, with which the hybrid is faster than the largest
/// hypercube, or 0 if the hybrid is never faster.
double crossover(double hypercube, const std::vector<Point>& hybrid) {
    auto faster = [&](const Point& point) { return point.x > most_islands && point.y > hypercube; };
    auto found = std::ranges::find_if(hybrid, faster);
    return found == hybrid.end() ? 0 : found->x;
}

double crossover_in(const StudyReplay& study, const Comparison& table, int alpha) {
    return crossover(speedups_of("hypercube", alpha, study, table).back().y,
                     speedups_of("hybrid", alpha, study, table));
}

/// Returns the number of processors as crossover() does, for the speedups of equation 4.9.
double crossover_by_formula(int alpha) {
    std::vector<Point> hybrid;
    for (int processors = 1; processors <= 1000; ++processors) // processors of each island
        hybrid.push_back({1.0 * hybrid_islands * processors, hybrid_islands * formula_4_9(alpha, processors)});
    return crossover(most_islands, hybrid);
}

/// Compares the crossovers (see crossover()) of the simulation with the crossovers of equation 4.9. Without
/// communication, they may differ by one step in the hybrid's size.
Comparison crossover_table(const StudyReplay& study, const Comparison& ideal, const Comparison& on_t800s) {
    Comparison table{.name = "number of processors from which the hybrid is faster than 16 islands of 6",
                     .against = "(4.9)"};
    for (int alpha : machine_alphas) {
        table.add(judged_cell(alpha_column(alpha), "no communication", "", crossover_by_formula(alpha),
                              crossover_in(study, ideal, alpha), hybrid_islands, 0));
        table.add(plain_cell(alpha_column(alpha), "on T800s", "", crossover_in(study, on_t800s, alpha), 0));
    }
    table.notes = "0: the hybrid is not faster with up to 48 processors\n";
    return table;
}

Panel architecture_panel(const std::string& title, const StudyReplay& study, const Comparison& table) {
    Panel panel{.title = title, .x = {.label = "processors", .from = 0}, .y = {.label = "speedup", .from = 0}};
    for (int colour = 1; int alpha : machine_alphas)
        panel.series.push_back({.name = fmt::format("hybrid, alpha {}", alpha),
                                .points = speedups_of("hybrid", alpha, study, table),
                                .colour = colour++});
    panel.series.push_back(
        {.name = "hypercube", .points = speedups_of("hypercube", machine_alphas[0], study, table), .colour = 0});
    return panel;
}

/// Mixes the fingerprints of the runs, alpha by alpha: one processor, the hypercube, the hybrid, and the hybrid with
/// alpha processors on each island. The printed fingerprint depends on this order.
std::uint64_t fingerprint_of(const StudyReplay& study) {
    Fingerprint fingerprint;
    for (int alpha : machine_alphas)
        for (const char* work : {"1000", "1"}) {
            auto mix = [&](int processors, int islands) {
                fingerprint.mix(study.fingerprint({{"alpha", fmt::format("{}", alpha)},
                                                   {"work", work},
                                                   {"processors", fmt::format("{}", processors)},
                                                   {"islands", fmt::format("{}", islands)},
                                                   {"individuals", "96"},
                                                   {"samples", "12"}}));
            };
            mix(1, 1);
            for (int islands = 1; islands <= most_islands; islands *= 2)
                mix(islands, islands);
            for (int processors = hybrid_islands; processors <= 48; processors += hybrid_islands)
                mix(processors, hybrid_islands);
            mix(hybrid_islands * alpha, hybrid_islands);
        }
    return fingerprint.value();
}

/// Sorts the cells: first the hypercube's cells by alpha, then the hybrid's cells by alpha.
void order_by_alpha(const StudyReplay& study, Comparison& table) {
    std::ranges::stable_sort(table.cells, {}, [&](const Cell& cell) {
        return std::tuple(cell.row.starts_with("hybrid"), study.number_in(cell.column));
    });
}

Replay replay_architectures(const ReplayContext& context) {
    const StudyReplay study(context, "explore/architectures/overtaking.toml");
    Replay replay = study.replay();
    for (Comparison& each : replay.comparisons)
        order_by_alpha(study, each);
    const Comparison ideal = study.table(replay, "speedup, communication takes no time"),
                     on_t800s = study.table(replay, "speedup on T800s");
    replay.comparisons.insert(replay.comparisons.begin(), crossover_table(study, ideal, on_t800s));
    replay.fingerprint = fingerprint_of(study);
    replay.plots = {{"architectures",
                     {"Islands alone and islands with slaves",
                      {architecture_panel("communication takes no time", study, ideal),
                       architecture_panel("on T800s, slaves in a chain", study, on_t800s)}}}};
    return replay;
}

} // namespace

extern const Experiment architectures_experiment{
    .name = "architectures",
    .about = "hypercube and hybrid architecture, and the number of processors at which the hybrid becomes faster",
    .chapter = "4",
    .number = 2,
    .run = replay_architectures,
};

} // namespace placedpar
