#include "experiments/chapter_4/kit/speedup_formulas.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::array machine_alphas{8, 16, 24};
/// Of all islands: 16 islands of 6, "small local population (6)", or 4 of 24, "sizable local population (24)"
/// (Figure 4.3).
constexpr int machine_individuals = 96, smallest_island = 6, sizable_island = 24;

/// One of the architectures, with so many processors.
struct MachineForm {
    int islands = 1, slaves = 0; ///< of each island
    bool communication = true;   ///< else computing takes a thousand times as long
    int processors() const { return islands * (slaves + 1); }
};

constexpr int hybrid_islands = machine_individuals / sizable_island;
constexpr int most_islands = machine_individuals / smallest_island;

class MachineRuns {
public:
    explicit MachineRuns(const ReplayContext& context) : context_(context) {}

    /// Against one processor that breeds all individuals.
    double speedup(const MachineForm& machine, int alpha) {
        return rate(machine, alpha) / alone(machine.communication, alpha);
    }

    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    double alone(bool communication, int alpha) {
        auto [found, is_new] = alone_.try_emplace({communication, alpha});
        if (is_new)
            found->second = rate({.communication = communication}, alpha);
        return found->second;
    }

    double rate(const MachineForm& machine, int alpha) {
        context_.progress(fmt::format("alpha {}, {} processors", alpha, machine.processors()));
        RunReport report = run_to_the_end(context_.examples / "66-architectures" / "architecture.cfs",
                                          {{"processors", std::to_string(machine.processors())},
                                           {"islands", std::to_string(machine.islands)},
                                           {"individuals", std::to_string(machine_individuals)},
                                           {"alpha", std::to_string(alpha)},
                                           {"work", std::to_string(machine.communication ? 1 : 1000)},
                                           {"samples", "12"}},
                                          context_);
        fingerprint_.mix(report.result.fingerprint);
        return report.measured("island[0]", "generations_per_second");
    }

    const ReplayContext& context_;
    std::map<std::pair<bool, int>, double> alone_; ///< rates of one processor, by communication and alpha
    Fingerprint fingerprint_;
};

double ideal_hybrid(int alpha, int slaves) { return hybrid_islands * formula_4_9(alpha, slaves + 1); }

/// The fewest slaves of each of the hybrid's islands with which it is faster than the largest hypercube; none of so
/// many.
template <class Speedup>
std::optional<int> crossover(double hypercube, int most_slaves, Speedup hybrid) {
    for (int slaves = most_islands / hybrid_islands; slaves <= most_slaves; ++slaves)
        if (hybrid(slaves) > hypercube)
            return slaves;
    return std::nullopt;
}

constexpr int most_hybrid_slaves = 11;

/// Both architectures' speedups, by processors.
struct Architectures {
    int alpha;
    std::vector<Point> hypercube, hybrid;
    double at_alpha = 0; ///< the hybrid's with alpha processors an island
};

Architectures measure_architectures(MachineRuns& runs, int alpha, bool communication) {
    Architectures found{.alpha = alpha, .hypercube = {}, .hybrid = {}};
    auto point = [&](const MachineForm& machine) {
        return Point{static_cast<double>(machine.processors()), runs.speedup(machine, alpha)};
    };
    for (int islands = 1; islands <= most_islands; islands *= 2)
        found.hypercube.push_back(point({islands, 0, communication}));
    for (int slaves = 0; slaves <= most_hybrid_slaves; ++slaves)
        found.hybrid.push_back(point({hybrid_islands, slaves, communication}));
    found.at_alpha = runs.speedup({hybrid_islands, alpha - 1, communication}, alpha);
    return found;
}

std::optional<int> crossover_of(const Architectures& found) {
    return crossover(found.hypercube.back().y, most_hybrid_slaves,
                     [&](int slaves) { return found.hybrid[static_cast<std::size_t>(slaves)].y; });
}

/// 0: there is none.
double processors_at(std::optional<int> slaves) { return slaves ? hybrid_islands * (*slaves + 1.0) : 0; }

/// Where communication takes nothing, that is what equation 4.9 says, to the next size.
Comparison crossover_table(const std::vector<Architectures>& ideal, const std::vector<Architectures>& on_t800s) {
    Comparison table{.name = "from how many processors on the hybrid is faster than 16 islands of 6",
                     .against = "(4.9)"};
    for (std::size_t i = 0; i < ideal.size(); ++i) {
        int alpha = ideal[i].alpha;
        auto row = fmt::format("alpha = {}", alpha);
        auto by_formula = crossover(most_islands, 1000, [&](int slaves) { return ideal_hybrid(alpha, slaves); });
        table.add(judged_cell(row, "no communication", "", processors_at(by_formula),
                              processors_at(crossover_of(ideal[i])), hybrid_islands, 0));
        table.add(plain_cell(row, "on T800s", "", processors_at(crossover_of(on_t800s[i])), 0));
    }
    table.notes = "0: it is not with up to 48\n";
    return table;
}

Comparison architecture_table(const std::string& name, const std::vector<Architectures>& all) {
    Comparison comparison{.name = name, .against = "ideal"};
    for (const Architectures& found : all) {
        auto column = fmt::format("alpha = {}", found.alpha);
        for (Point point : found.hypercube)
            comparison.add(
                compared_cell(fmt::format("hypercube, {} processors", point.x), column, "", point.x, point.y, 2));
    }
    for (const Architectures& found : all)
        for (std::size_t slaves = 0; slaves < found.hybrid.size(); ++slaves)
            comparison.add(compared_cell(
                fmt::format("hybrid, {} processors", found.hybrid[slaves].x), fmt::format("alpha = {}", found.alpha),
                "", ideal_hybrid(found.alpha, static_cast<int>(slaves)), found.hybrid[slaves].y, 2));
    return comparison;
}

/// Equation 4.11 beside the hybrid.
void add_combined(Comparison& table, double ideal, double on_t800s, int alpha) {
    auto column = fmt::format("alpha = {}", alpha);
    double known = formula_4_11(machine_individuals, sizable_island, alpha), processors = hybrid_islands * alpha;
    table.add(judged_cell("speedup", column, "", known, ideal, .01 * known, 2));
    table.add(judged_cell("efficiency", column, "", formula_c_2(known, processors), formula_c_2(ideal, processors),
                          .01 * formula_c_2(known, processors), 3));
    table.add(plain_cell("speedup on T800s", column, "", on_t800s, 2));
    table.add(plain_cell("efficiency on T800s", column, "", formula_c_2(on_t800s, processors), 3));
}

Comparison combined_table(const std::vector<Architectures>& ideal, const std::vector<Architectures>& on_t800s) {
    Comparison table{
        .name = "hybrid with alpha processors an island: 32, 64 and 96", .against = "(4.11)", .judged = true};
    for (std::size_t i = 0; i < ideal.size(); ++i)
        add_combined(table, ideal[i].at_alpha, on_t800s[i].at_alpha, ideal[i].alpha);
    table.notes = "efficiency: speedup over processors (C.2)\n";
    return table;
}

Panel architecture_panel(const std::string& title, const std::vector<Architectures>& all) {
    Panel panel{.title = title, .x = {.label = "processors", .from = 0}, .y = {.label = "speedup", .from = 0}};
    for (int colour = 1; const Architectures& found : all)
        panel.series.push_back(
            {.name = fmt::format("hybrid, alpha {}", found.alpha), .points = found.hybrid, .colour = colour++});
    panel.series.push_back({.name = "hypercube", .points = all.front().hypercube, .colour = 0});
    return panel;
}

Replay replay_architectures(const ReplayContext& context) {
    MachineRuns runs(context);
    std::vector<Architectures> ideal, on_t800s;
    for (int alpha : machine_alphas) {
        ideal.push_back(measure_architectures(runs, alpha, false));
        on_t800s.push_back(measure_architectures(runs, alpha, true));
    }
    return {.comparisons = {crossover_table(ideal, on_t800s), combined_table(ideal, on_t800s),
                            architecture_table("speedup, communication taking nothing", ideal),
                            architecture_table("speedup on T800s", on_t800s)},
            .constants =
                "   workload:   10 errors of an individual take table-e1's cycles, its breeding 1 / alpha of that\n",
            .fingerprint = runs.fingerprint(),
            .plots = {{"architectures",
                       {"Islands alone and islands with slaves",
                        {architecture_panel("communication taking nothing", ideal),
                         architecture_panel("on T800s, slaves in a chain", on_t800s)}}}}};
}

} // namespace

extern const Experiment architectures_experiment{
    .name = "architectures",
    .about = "hypercube and hybrid architecture, and where one overtakes the other",
    .chapter = "4",
    .number = 2,
    .run = replay_architectures,
};

} // namespace placedpar
