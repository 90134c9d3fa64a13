#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// A form of a farm: slaves at links of the master's own, and to how many each slave passes on.
struct FarmForm {
    const char* name;
    int links, branches;
};

constexpr FarmForm farm_chain{"chain", 1, 1};
/// With three slaves or fewer it is a star, a link for each slave.
constexpr FarmForm farm_chains{"3 chains", 3, 1};
constexpr FarmForm farm_tree{"tree", 3, 3};
/// As on the machine of Figure E.2, where a master has one link left.
constexpr FarmForm farm_tree_on_one_link{"tree, 1 link", 1, 3};

constexpr std::array farm_forms{farm_chain, farm_chains, farm_tree, farm_tree_on_one_link};
constexpr std::array farm_sizes{1, 2, 3, 4, 5, 6, 8, 10, 12, 15};

Overrides overrides_of(const FarmForm& form, int slaves) {
    return {{"slaves", std::to_string(slaves)},
            {"links", std::to_string(form.links)},
            {"branches", std::to_string(form.branches)}};
}

/// Runs the netlist of the farm, and gathers the fingerprints.
class FarmRuns {
public:
    explicit FarmRuns(const ReplayContext& context) : context_(context) {}

    RunReport run(const FarmForm& form, int slaves, const Overrides& others = {}) {
        context_.progress(fmt::format("{}: {} slaves", form.name, slaves));
        Overrides overrides = overrides_of(form, slaves);
        for (const auto& [name, value] : others)
            overrides[name] = value;
        RunReport report = run_to_the_end(context_.examples / "36-farms" / "farm.cfs", overrides, context_);
        fingerprint_.mix(report.result.fingerprint);
        return report;
    }

    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    const ReplayContext& context_;
    Fingerprint fingerprint_;
};

double farm_time(const RunReport& report, const char* name) { return report.measured("master", name); }

/// Nothing but links: processors so fast that they take no time beside them, and neither calls nor conversions.
Overrides links_only() {
    return {{"clock", "1000000000"}, {"library_call", "0"}, {"cycles_per_measurement_word", "0"}};
}

Overrides with(Overrides overrides, std::string name, std::string value) {
    overrides[std::move(name)] = std::move(value);
    return overrides;
}

/// Appendix E's claim: 0.4 ms, one digit, so from 0.35 to 0.45.
constexpr double claimed_ms = 0.4, claim_digit_ms = 0.05;
/// What table-e1.md's hypothesis leaves of a chain's time when nothing is passed on: 3 x (0.377 ms of software + 268
/// bytes at 1740 bytes/ms).
constexpr double star_by_hand_ms = 3 * (0.377 + 268.0 / 1740);

Comparison run_claim(FarmRuns& runs) {
    Comparison comparison{.name = "appendix E: a link for each of three slaves takes .4 ms where the chain took 1.89"};
    auto c_time2 = [&](const FarmForm& form, int slaves, const Overrides& others) {
        return farm_time(runs.run(form, slaves, others), "C_time2");
    };
    auto cell = [](const char* row, double known, double simulated, double tolerance) {
        return judged_cell(row, "C_time2", "ms", known, simulated, tolerance, 2);
    };
    const Overrides at_once{{"sending", "\"at once\""}};
    comparison.add(compared_cell("the chain, to which a constant is fitted", "C_time2", "ms", 1.89,
                                 c_time2(farm_chain, 3, {}), 2));
    comparison.add(cell("what the thesis computed: 628 bytes over a link", claimed_ms,
                        c_time2(farm_chain, 1, with(links_only(), "population", "240")), claim_digit_ms));
    comparison.add(
        compared_cell("a star, links only", "C_time2", "ms", claimed_ms, c_time2(farm_chains, 3, links_only()), 2));
    comparison.add(compared_cell("a star, links only, all at once", "C_time2", "ms", claimed_ms,
                                 c_time2(farm_chains, 3, with(links_only(), "sending", "\"at once\"")), 2));
    comparison.add(compared_cell("a star, with the chain's software", "C_time2", "ms", claimed_ms,
                                 c_time2(farm_chains, 3, {}), 2));
    comparison.add(
        compared_cell("  and all links at once", "C_time2", "ms", claimed_ms, c_time2(farm_chains, 3, at_once), 2));
    comparison.notes = fmt::format(
        "the chain's calculation by hand, with nothing passed on, gives the star {:.2f} ms\n", star_by_hand_ms);
    return comparison;
}

/// Of every form, with each number of slaves.
using FarmSweep = std::map<std::pair<std::string, int>, RunReport>;

FarmSweep run_sweep(FarmRuns& runs) {
    FarmSweep sweep;
    for (const FarmForm& form : farm_forms)
        for (int slaves : farm_sizes)
            sweep.emplace(std::pair(form.name, slaves),
                          runs.run(form, slaves, {{"samples", "12"}, {"master.rehearsals", "25"}}));
    return sweep;
}

std::string farm_size(int slaves) { return fmt::format("{} slave{}", slaves, slaves == 1 ? "" : "s"); }

Comparison sweep_table(const FarmSweep& sweep, const char* measured, const std::string& about) {
    Comparison comparison{.name = fmt::format("{}: {}", measured, about)};
    for (int slaves : farm_sizes)
        for (const FarmForm& form : farm_forms)
            comparison.add(
                plain_cell(farm_size(slaves), form.name, "ms", farm_time(sweep.at({form.name, slaves}), measured), 2));
    return comparison;
}

/// The share of the run for which a slave's processor worked, in percent: of the slave that works least, and the mean.
struct SlavesBusy {
    double least = 100, mean = 0;
};

SlavesBusy busy_slaves(const RunReport& report) {
    SlavesBusy busy;
    for (std::size_t slave = 1; slave < report.processors.size(); ++slave) {
        double percent = 100 * report.share(report.processors[slave].busy).value_or(0);
        busy.least = std::min(busy.least, percent);
        busy.mean += percent / static_cast<double>(report.processors.size() - 1);
    }
    return busy;
}

std::string farm_title(const FarmForm& form, int slaves) {
    return fmt::format("{} of {}", slaves <= form.links ? "star" : form.name, slaves);
}

Overrides with_under_way(int tasks) {
    return {{"split", "\"demand\""},
            {"tasks_under_way", std::to_string(tasks)},
            {"samples", "12"},
            {"master.rehearsals", "0"}};
}

void add_under_way(Comparison& comparison, FarmRuns& runs, const FarmForm& form, int slaves, int under_way) {
    RunReport report = runs.run(form, slaves, with_under_way(under_way));
    auto column = fmt::format("{} under way", under_way);
    auto row = [&](const char* what) { return fmt::format("{}, {}", farm_title(form, slaves), what); };
    SlavesBusy busy = busy_slaves(report);
    comparison.add(plain_cell(row("T_sr"), column, "ms", farm_time(report, "T_sr"), 2));
    comparison.add(plain_cell(row("slaves busy"), column, "%", busy.mean, 1));
    comparison.add(plain_cell(row("the least busy"), column, "%", busy.least, 1));
}

Comparison run_under_way(FarmRuns& runs) {
    Comparison comparison{.name = "dealt out on demand: several tasks under way to each slave"};
    for (auto [form, slaves] :
         {std::pair(farm_chain, 3), std::pair(farm_chains, 3), std::pair(farm_chain, 15), std::pair(farm_tree, 15)})
        for (int under_way : {1, 2, 3})
            add_under_way(comparison, runs, form, slaves, under_way);
    comparison.notes =
        "busy: the part of the run in which a slave's processor worked; while the master breeds, none does\n";
    return comparison;
}

Point sweep_point(const FarmSweep& sweep, const char* measured, const FarmForm& form, int slaves) {
    return {static_cast<double>(slaves), farm_time(sweep.at({form.name, slaves}), measured)};
}

std::vector<Point> sweep_points(const FarmSweep& sweep, const char* measured, const FarmForm& form) {
    std::vector<Point> points;
    for (int slaves : farm_sizes)
        points.push_back(sweep_point(sweep, measured, form, slaves));
    return points;
}

Panel farm_panel(const FarmSweep& sweep, const char* measured, const std::string& title) {
    Panel panel{.title = title, .x = {.label = "slaves"}, .y = {.label = fmt::format("{} [ms]", measured), .from = 0}};
    for (const FarmForm& form : farm_forms)
        panel.series.push_back({.name = form.name, .points = sweep_points(sweep, measured, form)});
    return panel;
}

NamedPlot farm_plot(const FarmSweep& sweep) {
    Panel communication = farm_panel(sweep, "C_time2", "communication of a generation");
    communication.series.push_back(
        {.name = "Table E.1", .points = {{1, 0.6}, {2, 1.28}, {3, 1.89}}, .stroke = Stroke::points});
    communication.marks.push_back({.name = "appendix E: a link each", .y = claimed_ms});
    return {"farms",
            {"Forms of a farm over the number of slaves", {communication, farm_panel(sweep, "T_exe", "a generation")}}};
}

Replay replay_farms(const ReplayContext& context) {
    FarmRuns runs(context);
    Replay replay{.comparisons = {run_claim(runs)}};
    FarmSweep sweep = run_sweep(runs);
    replay.comparisons.push_back(sweep_table(sweep, "C_time2", "the communication of a generation"));
    replay.comparisons.push_back(sweep_table(sweep, "T_exe", "a generation"));
    replay.comparisons.push_back(run_under_way(runs));
    replay.constants = "   3 chains and the tree of 1 to 3 slaves are stars. Workload, calibration and published "
                       "constants are those of\n"
                       "   table-e1.\n";
    replay.fingerprint = runs.fingerprint();
    replay.plots = {farm_plot(sweep)};
    return replay;
}

} // namespace

extern const Experiment farms_experiment{
    .name = "farms",
    .about = "what communication costs with slaves in a chain, a star and trees",
    .chapter = "E",
    .number = 3,
    .run = replay_farms,
};

} // namespace placedpar
