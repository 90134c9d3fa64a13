#include "experiments/chapter_4/kit/speedup_formulas.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "gaprocs/processes/share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::array speedup_alphas{8, 16, 24};
constexpr std::array speedup_processors{2, 3, 4, 6, 8, 12, 16, 20, 24, 28};
/// The factor by which computations are made longer, so that communication is negligible.
constexpr int speedup_work_alone = 1000;

/// Returns m / s, the ratio with which all processors work equally long: m is the master's share and s a slave's share
/// of t_p, the time for evaluating a generation (equation 4.5). The master also breeds, so s = m + 1 / alpha. With n
/// slaves, n s + m = 1. It follows that m / s = (alpha - n) / (alpha + 1).
double balanced_share(int alpha, int slaves) { return std::max(0.0, 1.0 * (alpha - slaves) / (alpha + 1)); }

constexpr std::size_t whole_evaluations = 30 * 10; ///< evaluations of a population of 30 in a window of 10

/// Returns the fraction of a generation's evaluations that each processor makes. The master's fraction is last.
std::vector<double> parts_of_whole_evaluations(int processors, double own_share) {
    std::vector<double> parts;
    auto slaves = static_cast<std::size_t>(processors - 1);
    for (const Share& share : deal(30, 10, slaves, Split::evaluations, own_share))
        parts.push_back(static_cast<double>(share.evaluations()) / whole_evaluations);
    return parts;
}

/// Returns the speedup of equation 4.9 if each of the 300 evaluations is made by one processor. All processors then
/// wait for the processor with the most evaluations.
double whole_4_9(int alpha, int processors) {
    auto parts = parts_of_whole_evaluations(processors, 1);
    return (alpha + 1) / (alpha * *std::ranges::max_element(parts) + 1);
}
double whole_pipelined(int alpha, int processors) {
    auto parts = parts_of_whole_evaluations(processors, balanced_share(alpha, processors - 1));
    parts.back() += 1.0 / alpha; // the master also breeds
    return (1 + 1.0 / alpha) / *std::ranges::max_element(parts);
}

/// Returns the times of a generation, in units of the breeding time.
GenerationTimes times_at(int alpha, double communication) {
    return {.evaluating = 1.0 * alpha, .breeding = 1, .communication = communication};
}

struct SpeedupPoint {
    int alpha, processors, populations, work;
    bool only_breeding = false; ///< whether the master breeds but does not evaluate
    auto operator<=>(const SpeedupPoint&) const = default;
};

Overrides overrides_of(const SpeedupPoint& point) {
    Overrides overrides{{"alpha", std::to_string(point.alpha)},
                        {"processors", std::to_string(point.processors)},
                        {"populations", std::to_string(point.populations)},
                        {"work", std::to_string(point.work)},
                        {"samples", "12"}};
    if (point.only_breeding)
        overrides["own_share"] = "0";
    return overrides;
}

/// Runs the netlist once for each SpeedupPoint, and keeps the reports.
class SpeedupRuns {
public:
    explicit SpeedupRuns(const ReplayContext& context) : context_(context) {}

    const RunReport& run(const SpeedupPoint& point) {
        if (auto found = runs_.find(point); found != runs_.end())
            return found->second;
        context_.progress(fmt::format("alpha {}, {} processors", point.alpha, point.processors));
        RunReport report =
            run_to_the_end(context_.examples / "explore/pipeline" / "pipeline.cfs", overrides_of(point), context_);
        fingerprint_.mix(report.result.fingerprint);
        return runs_.emplace(point, std::move(report)).first->second;
    }

    /// Returns the number of generations that all populations together make in the time that one generation takes on a
    /// single processor.
    double speedup(const SpeedupPoint& point) { return rate(point) / alone(point).measured("master[0]", rate_name); }

    /// Returns n t_c2 of equation 4.9 (the communication time of a generation), in units of the breeding time t_s. As
    /// in the thesis, n t_c2 is measured in a generation in which nothing is evaluated. A generation on one processor
    /// takes (alpha + 1) t_s.
    double communication(const SpeedupPoint& point) {
        return (point.alpha + 1) * run(point).measured("master[0]", "C_time2") /
               alone(point).measured("master[0]", "T_exe");
    }

    /// Returns whether a population goes through the same generations in all runs: on one processor, in parallel, and
    /// with a pipeline.
    bool are_the_same_generations() {
        std::map<std::string, std::string> populations;
        for (const auto& [point, report] : runs_)
            for (int master = 0; master < point.populations; ++master) {
                auto name = fmt::format("master[{}]", master);
                auto generations = report.measured_text(name, "populations");
                if (populations.emplace(name, generations).first->second != generations)
                    return false;
            }
        return true;
    }

    std::size_t count() const { return runs_.size(); }
    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    static constexpr const char* rate_name = "generations_per_second";

    const RunReport& alone(const SpeedupPoint& point) { return run({point.alpha, 1, 1, point.work}); }

    double rate(const SpeedupPoint& point) {
        const RunReport& report = run(point);
        double sum = 0;
        for (int master = 0; master < point.populations; ++master)
            sum += report.measured(fmt::format("master[{}]", master), rate_name);
        return sum;
    }

    const ReplayContext& context_;
    std::map<SpeedupPoint, RunReport> runs_;
    Fingerprint fingerprint_;
};

template <class CellOf>
Comparison speedup_table(std::string name, std::string against, CellOf cell_of) {
    Comparison comparison{.name = std::move(name), .against = std::move(against)};
    for (int processors : speedup_processors)
        for (int alpha : speedup_alphas)
            comparison.add(
                cell_of(fmt::format("{} processors", processors), fmt::format("alpha = {}", alpha), alpha, processors));
    return comparison;
}

Comparison run_figure_4_6(SpeedupRuns& runs) {
    return speedup_table("Figure 4.6: speedup, not pipelined, communication takes no time", "(4.9)",
                         [&](auto row, auto column, int alpha, int processors) {
                             double known = whole_4_9(alpha, processors);
                             return judged_cell(row, column, "", known,
                                                runs.speedup({alpha, processors, 1, speedup_work_alone}), .01 * known,
                                                2);
                         });
}

Comparison run_figure_4_7(SpeedupRuns& runs) {
    Comparison comparison =
        speedup_table("Figure 4.7: speedup, pipelined, communication takes no time", "ideal",
                      [&](auto row, auto column, int alpha, int processors) {
                          double known = whole_pipelined(alpha, processors);
                          return judged_cell(row, column, "", known,
                                             runs.speedup({alpha, processors, 2, speedup_work_alone}), .03 * known, 2);
                      });
    comparison.judged = true;
    comparison.notes = "ideal: the number of processors, at most alpha + 1\n"
                       "both figures: 300 evaluations are dealt out whole, so the processor with the most evaluations "
                       "limits the speedup\n";
    return comparison;
}

Comparison run_on_t800s(SpeedupRuns& runs) {
    Comparison comparison = speedup_table(
        "on T800s in a chain, not pipelined", "(4.9)", [&](auto row, auto column, int alpha, int processors) {
            SpeedupPoint point{alpha, processors, 1, 1};
            return compared_cell(row, column, "", formula_c_1(times_at(alpha, runs.communication(point)), processors),
                                 runs.speedup(point), 2);
        });
    comparison.notes = "equation (4.9) is computed with the n t_c2 that each run measured (C_time2)\n";
    return comparison;
}

Comparison run_pipelined_on_t800s(SpeedupRuns& runs) {
    return speedup_table("on T800s in a chain, pipelined", "", [&](auto row, auto column, int alpha, int processors) {
        return plain_cell(row, column, "", runs.speedup({alpha, processors, 2, 1}), 2);
    });
}

/// A speedup computed by a formula, and by how much the simulated speedup may differ from it.
struct FormulaSpeedup {
    double known;
    double whole;   ///< speedup if no evaluation is divided between processors; its difference from `known` is allowed
    double allowed; ///< additional tolerance, relative to `known`
    double tolerance() const { return std::abs(known - whole) + allowed * known; }
};

/// Returns the efficiency by equation C.2 (speedup per processor) for the simulated speedup.
double simulated_efficiency(SpeedupRuns& runs, const SpeedupPoint& point) {
    return formula_c_2(runs.speedup(point), point.processors);
}

Cell efficiency_cell(SpeedupRuns& runs, std::string row, const SpeedupPoint& point, const FormulaSpeedup& formula) {
    return judged_cell(std::move(row), fmt::format("alpha = {}", point.alpha), "",
                       formula_c_2(formula.known, point.processors), simulated_efficiency(runs, point),
                       formula_c_2(formula.tolerance(), point.processors), 3);
}

void add_at_alpha(Comparison& comparison, SpeedupRuns& runs, int alpha) {
    auto column = fmt::format("alpha = {}", alpha);
    SpeedupPoint plain{alpha, alpha, 1, speedup_work_alone}, pipelined{alpha, alpha, 2, speedup_work_alone};
    SpeedupPoint only_breeding{alpha, alpha + 1, 1, speedup_work_alone, true};
    FormulaSpeedup half{.known = formula_4_10(alpha), .whole = whole_4_9(alpha, alpha), .allowed = .01};
    FormulaSpeedup full{
        .known = formula_pipelined(alpha, alpha), .whole = whole_pipelined(alpha, alpha), .allowed = .03};
    comparison.add(judged_by(Judge::thesis, judged_cell("speedup (4.10)", column, "", half.known, runs.speedup(plain),
                                                        half.tolerance(), 3)));
    comparison.add(judged_by(Judge::thesis, efficiency_cell(runs, "efficiency (C.2)", plain, half)));
    comparison.add(efficiency_cell(runs, "efficiency, a master that only breeds", only_breeding, half));
    comparison.add(efficiency_cell(runs, "efficiency, pipelined", pipelined, full));
    plain.work = pipelined.work = 1;
    comparison.add(plain_cell("efficiency on T800s", column, "", simulated_efficiency(runs, plain), 3));
    comparison.add(plain_cell("efficiency on T800s, pipelined", column, "", simulated_efficiency(runs, pipelined), 3));
}

Comparison run_at_alpha(SpeedupRuns& runs) {
    Comparison comparison{.name = "alpha processors evaluate", .against = "formula", .judged = true};
    for (int alpha : speedup_alphas)
        add_at_alpha(comparison, runs, alpha);
    comparison.notes = "efficiency: speedup / processors; a master that only breeds adds one processor to "
                       "alpha\ntolerance: the effect of whole evaluations plus 1 %; if pipelined, plus 3 %\n";
    return comparison;
}

Comparison run_same_generations(SpeedupRuns& runs) {
    Comparison comparison{.name = "generations", .against = "known", .judged = true};
    comparison.add(at_least(1, plain_cell(fmt::format("equal in all {} runs [1: yes]", runs.count()), "populations", "",
                                          runs.are_the_same_generations() ? 1 : 0, 0)));
    return comparison;
}

Series speedup_series(SpeedupRuns& runs, std::string name, int alpha, int populations, int work, int colour) {
    Series series{.name = std::move(name), .points = {{1, 1}}, .stroke = Stroke::points, .colour = colour};
    for (int processors : speedup_processors)
        series.points.push_back(
            {static_cast<double>(processors), runs.speedup({alpha, processors, populations, work})});
    return series;
}

/// Plots a figure: the formula, the simulation without the cost of communication, and the simulation on T800s.
Panel speedup_panel(SpeedupRuns& runs, std::string title, int populations, double (*formula)(double, double)) {
    Panel panel{
        .title = std::move(title), .x = {.label = "processors"}, .y = {.label = "speedup", .from = 0, .to = 26}};
    for (int colour = 0; int alpha : speedup_alphas) {
        panel.series.push_back(
            curve({.name = fmt::format("alpha {}, formula", alpha), .colour = colour}, 108, [&](int i) {
                return Point{1 + .25 * i, formula(alpha, 1 + .25 * i)};
            }));
        panel.series.push_back(
            speedup_series(runs, fmt::format("... simulated"), alpha, populations, speedup_work_alone, colour));
        Series on_t800s = speedup_series(runs, "... on T800s", alpha, populations, 1, colour++);
        on_t800s.stroke = Stroke::dashes;
        panel.series.push_back(std::move(on_t800s));
    }
    return panel;
}

std::vector<NamedPlot> speedup_plots(SpeedupRuns& runs) {
    return {{"figures-4-6-4-7",
             {"Speedup and number of processors",
              {speedup_panel(runs, "Figure 4.6: not pipelined", 1, formula_4_9),
               speedup_panel(runs, "Figure 4.7: pipelined", 2, formula_pipelined)}}}};
}

Replay replay_speedup(const ReplayContext& context) {
    SpeedupRuns runs(context);
    Replay replay{
        .comparisons = {run_figure_4_6(runs), run_figure_4_7(runs), run_on_t800s(runs), run_pipelined_on_t800s(runs)}};
    replay.comparisons.push_back(run_at_alpha(runs));
    replay.comparisons.push_back(run_same_generations(runs));
    replay.constants =
        "   workload:   the 10 error evaluations of an individual take the cycles of table-e1, and breeding takes\n"
        "               1 / alpha of them; both are multiplied by 1,000 where communication takes no time\n"
        "   own share:  with a pipeline the master evaluates (alpha - slaves) / (alpha + 1) of a slave's share, so\n   "
        "            that both work equally long; without a pipeline the share is 1, or 0 if the master only breeds\n";
    replay.fingerprint = runs.fingerprint();
    replay.plots = speedup_plots(runs);
    return replay;
}

} // namespace

extern const Experiment figures_4_6_4_7_experiment{
    .name = "figures-4-6-4-7",
    .about = "speedup of algorithm A with and without a pipeline",
    .chapter = "4",
    .number = 1,
    .run = replay_speedup,
};

} // namespace placedpar
