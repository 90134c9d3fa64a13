#include "experiments/chapter_4/kit/parallel_identification.hpp"

#include "experiments/chapter_3/kit/boom_plots.hpp"
#include "experiments/chapter_3/kit/boom_search.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "explore/netlist_run.hpp"
#include "explore/process_search.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr double near_truth = 0.1; ///< largest relative error of an answer that has converged
constexpr double plotted_s = 1.2;

/// A simulated boom, the noise of its sensors, and whether the search's model has the same structure as the boom.
struct RecordedBoom {
    const char* name;
    BoomPlant plant;
    MeasurementNoise noise;
    bool has_the_models_structure;
};
constexpr RecordedBoom simple_boom{"simple plant, low noise", BoomPlant::simple, low_noise, true};
constexpr RecordedBoom measured_boom{"measured machine, mid noise", BoomPlant::measured, mid_noise, false};

enum BoomWay : std::size_t { ga_alone, pga_fittest, pga_first, boom_ways };
constexpr std::array<const char*, boom_ways> names_of_boom_ways{"GA, 1 T800", "PGA, fittest", "PGA, master[0]"};

/// A finished search on a machine, with one island or several.
struct MachineSearch {
    ProcessSearch search;
    SearchAnswers answers;

    std::size_t last() const { return answers.generations() - 1; }
    double answer(std::size_t island, std::size_t generation) const { return answers.of(island, generation).values[0]; }
};

MachineSearch search_on(const ReplayContext& context, const Overrides& set, const ComplianceSearch& prepared,
                        std::uint64_t seed) {
    const std::filesystem::path path = context.examples / "thesis/figure-e2/figure-e2.cfs";
    NetlistAsked netlist{path, set, ParsedNetlist(path), {}};
    ProcessSearch search = search_by_processes(netlist, prepared, rising_way(), context.warn);
    SearchAnswers answers = search.answers();
    run_netlist(search.network, search.problems, {.seed = seed, .observer = &answers});
    return {std::move(search), std::move(answers)};
}

struct BothSearches {
    BoomModel model;
    BoomIdentified natively;
    MachineSearch alone, islands;
};

BothSearches search_both(const ReplayContext& context, const BoomData& data, AreasFrom from, std::uint64_t seed) {
    BoomModel model = model_of(data, from);
    BoomIdentified natively = identify_boom(data, model, rising_way(), seed);
    const ComplianceSearch prepared{CircuitProblem(boom_circuit(), data.flow, rising_way().bits), data.flow,
                                    calibrations_of(data, model), natively.samples};
    return {model, std::move(natively), search_on(context, {{"clusters", "1"}, {"slaves", "0"}}, prepared, seed),
            search_on(context, {}, prepared, seed)};
}

/// Returns the result of a search. The answers are those of one island or, if `island` is empty, those of the fittest
/// island in each generation.
FoundInRecord found_by(const MachineSearch& run, std::optional<std::size_t> island, double truth) {
    const std::size_t trials = run.search.trials;
    auto answer = [&](std::size_t generation) {
        return run.answer(island.value_or(run.answers.fittest(generation)), generation);
    };
    double converged = static_cast<double>(run.answers.generations() + trials);
    for (std::size_t end = run.answers.generations(); end >= trials; end -= trials) {
        if (!(std::abs(answer(end - 1) / truth - 1) <= near_truth))
            break;
        converged = static_cast<double>(end);
    }
    return {answer(run.last()), converged, in_milliseconds(run.answers.ready(run.last())) / 1000};
}

Figures figures_of_both(const BothSearches& both, double truth) {
    Figures figures;
    for (const FoundInRecord& found : {found_by(both.alone, 0, truth), found_by(both.islands, std::nullopt, truth),
                                       found_by(both.islands, 0, truth)})
        for (double figure : {found.compliance_in3_per_psi, found.generations, found.seconds})
            figures.push_back(figure);
    return figures;
}

std::vector<FoundInRecord> found_by_way(const std::vector<Figures>& runs, std::size_t way) {
    std::vector<FoundInRecord> found;
    for (const Figures& figures : runs)
        found.push_back({figures[3 * way], figures[3 * way + 1], figures[3 * way + 2]});
    return found;
}

bool is_near(const FoundInRecord& found, double truth) {
    return std::abs(found.compliance_in3_per_psi / truth - 1) <= near_truth;
}

double mean_of(const std::vector<FoundInRecord>& found, double FoundInRecord::*figure) {
    double sum = 0;
    for (const FoundInRecord& each : found)
        sum += each.*figure;
    return sum / static_cast<double>(found.size());
}

void add_way(Comparison& comparison, const char* column, const std::vector<FoundInRecord>& found, double truth,
             bool judged) {
    auto near = std::ranges::count_if(found, [&](const FoundInRecord& each) { return is_near(each, truth); });
    Cell share = share_cell("last answer within 10 %", column, static_cast<std::size_t>(near), found.size());
    comparison.add(judged ? at_least(90, share) : share);
    comparison.add(plain_cell("  interval from", column, "%", share.interval->low, 0));
    comparison.add(plain_cell("  to", column, "%", share.interval->high, 0));
    comparison.add(compared_cell("C_BOi, mean", column, "in^3/psi", truth,
                                 mean_of(found, &FoundInRecord::compliance_in3_per_psi), 5));
    comparison.add(
        plain_cell("within 10 % from generation", column, "", mean_of(found, &FoundInRecord::generations), 1));
    comparison.add(plain_cell("last answer after", column, "s", mean_of(found, &FoundInRecord::seconds), 3));
}

/// Returns a cell with the mean of paired differences and the 95 % interval of this mean.
Cell difference_cell(std::string row, const std::string& column, std::string unit,
                     const std::vector<double>& differences, int decimals) {
    // Half the width of the interval, in standard deviations of a normally distributed mean.
    constexpr double of_95_percent = 1.96;
    const double middle = mean(differences);
    const double half = of_95_percent * deviation(differences) / std::sqrt(static_cast<double>(differences.size()));
    Cell cell = plain_cell(std::move(row), column, std::move(unit), middle, decimals);
    cell.interval = {middle - half, middle + half};
    return cell;
}

/// Returns the difference in each record: parallel minus traditional.
std::vector<double> differences_of(const BothFound& found, const std::function<double(const FoundInRecord&)>& figure) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < found.parallel.size(); ++i)
        differences.push_back(figure(found.parallel[i]) - figure(found.traditional[i]));
    return differences;
}

void add_with_ends(Comparison& comparison, Cell cell) {
    const Interval interval = *cell.interval;
    Cell low = plain_cell(cell.row + ", from", cell.column, cell.unit, interval.low, cell.decimals);
    Cell high = plain_cell(cell.row + ", to", cell.column, cell.unit, interval.high, cell.decimals);
    comparison.add(std::move(cell));
    comparison.add(std::move(low));
    comparison.add(std::move(high));
}

Comparison both_algorithms(const RecordedBoom& machine, const std::vector<Figures>& runs, double truth) {
    Comparison comparison{.name = fmt::format("{}: what both algorithms find, {} records", machine.name, runs.size()),
                          .against = "true",
                          .judged = true};
    for (std::size_t way = 0; way < boom_ways; ++way)
        add_way(comparison, names_of_boom_ways[way], found_by_way(runs, way), truth,
                machine.has_the_models_structure && way != pga_first);
    return comparison;
}

/// Returns "shown", "undecided" or "refuted", by the interval of a difference and its bounds.
std::string shown_by(const Cell& cell) {
    const bool meets = cell.interval->low >= cell.at_least.value_or(cell.interval->low) &&
                       cell.interval->high <= cell.at_most.value_or(cell.interval->high);
    return meets ? "shown" : cell.within_tolerance() ? "undecided" : "refuted";
}

/// Adds the differences for one way of choosing the answer, and notes that say what these differences show. Only
/// `pga_fittest` is judged, because the fittest island's answer is the parallel algorithm's answer.
void add_differences(Comparison& comparison, const BothFound& found, BoomWay way) {
    comparison.notes += fmt::format("{}:", names_of_boom_ways[way]);
    for (Cell& cell : cells_of_difference(found, names_of_boom_ways[way])) {
        comparison.notes += fmt::format(" {} {};", cell.row, shown_by(cell));
        if (way != pga_fittest)
            cell.at_least = cell.at_most = std::nullopt;
        add_with_ends(comparison, std::move(cell));
    }
    comparison.notes.back() = '\n';
}

Comparison difference_table(const RecordedBoom& machine, const std::vector<Figures>& runs, double truth) {
    Comparison comparison{
        .name = fmt::format("{}: PGA minus GA on the same records, mean of {}", machine.name, runs.size()),
        .notes =
            "\"almost identical\" allows 5 percentage points fewer records, 2 % of the true C_BOi more or less, and "
            "5 generations\n(one sample) more. A claim is shown if the whole 95 % interval of the mean is within the "
            "bound, and refuted if\nthe whole interval is beyond it. A refuted claim misses its bound.\n",
        .against = "claim",
        .judged = true};
    for (BoomWay way : {pga_fittest, pga_first})
        add_differences(comparison, {truth, found_by_way(runs, ga_alone), found_by_way(runs, way)}, way);
    return comparison;
}

BoomMotion motion_of_machine(const RecordedBoom& machine) { return {machine.plant, machine.noise}; }

/// Makes the searches with the records of one machine, for all seeds.
std::vector<Comparison> compare_on(const ReplayContext& context, const RecordedBoom& machine, AreasFrom from) {
    const Seeds seeds = seeds_of(context);
    const std::vector<BoomData> records = measure(motion_of_machine(machine), seeds);
    const double truth = records.front().boom.inlet_compliance_in3_per_psi;
    auto runs = run_seeds(context, machine.name, [&](std::uint64_t seed) {
        auto record = static_cast<std::size_t>(std::ranges::find(seeds, seed) - seeds.begin());
        return figures_of_both(search_both(context, records[record], from, seed), truth);
    });
    return {difference_table(machine, runs, truth), both_algorithms(machine, runs, truth)};
}

/// Returns the numbers of the generations with the times at which they are drawn. The generations after a sample are
/// spread evenly over the time until the next sample.
std::vector<std::pair<double, std::size_t>> generations_by_time(const BothSearches& both) {
    std::vector<std::pair<double, std::size_t>> all;
    const ProcessSearch& search = both.islands.search;
    const double spacing_s = both.natively.samples[1].time_s - both.natively.samples[0].time_s;
    for (std::size_t generation = 0; generation < both.islands.answers.generations(); ++generation) {
        const double sample_s = both.natively.samples[search.first - 1 + generation / search.trials].time_s;
        const auto trial = static_cast<double>(generation % search.trials);
        all.emplace_back(sample_s + trial * spacing_s / static_cast<double>(search.trials), generation);
    }
    return all;
}

std::vector<Series>
curves_of_searches(const BothSearches& both,
                   const std::function<double(const MachineSearch&, std::size_t, std::size_t)>& value) {
    std::vector<Series> series{{"GA", {}}};
    for (const std::string& island : both.islands.answers.searches())
        series.push_back({island, {}, Stroke::plain});
    for (const auto& [time_s, generation] : generations_by_time(both)) {
        series[0].points.push_back({time_s, value(both.alone, 0, generation)});
        for (std::size_t island = 0; island + 1 < series.size(); ++island)
            series[island + 1].points.push_back({time_s, value(both.islands, island, generation)});
    }
    return series;
}

/// Returns the root mean square of the best individual's error (equation 3.8) over the window of a generation.
double window_error(const MachineSearch& run, std::size_t island, std::size_t generation) {
    const WindowSettings window = rising_way().search.window;
    const std::size_t samples = std::min(run.search.first + generation / run.search.trials, window.length);
    const double mean_square = window.bias - run.answers.of(island, generation).fitness / static_cast<double>(samples);
    return std::max(std::sqrt(std::max(mean_square, 0.0)), 0.01);
}

/// Draws Figure 4.9 or 4.10 in the form of Figures 3.5 and 3.6, from the same record.
Plot plot_of_both(const ReplayContext& context, const ParallelExperiment& experiment) {
    const std::uint64_t seed = seeds_of(context).front();
    const BoomData data = measure(motion_of_machine(measured_boom), seed);
    const BothSearches both = search_both(context, data, experiment.from, seed);
    Plot plot = plot_of_identification({experiment.title, data, both.model, both.natively, {}}, plotted_s);
    Panel &compliance = plot.panels[3], &error = plot.panels[4];
    compliance.series =
        curves_of_searches(both, [](const MachineSearch& run, std::size_t island, std::size_t generation) {
            return 1000 * run.answer(island, generation);
        });
    error.series = curves_of_searches(both, window_error);
    compliance.title = "c: estimated C_BOi, best individual of each generation";
    error.title = "d: Error of the best individual, rms over the window";
    const double from_s = both.natively.found.estimates.front().time_s - 0.02,
                 to_s = both.natively.samples.back().time_s + 0.02;
    error.y.from = 0.1;
    error.y.to = 100;
    compliance.x.from = error.x.from = from_s;
    compliance.x.to = error.x.to = to_s;
    return plot;
}

} // namespace

std::vector<Cell> cells_of_difference(const BothFound& found, const std::string& column) {
    const double truth = found.true_in3_per_psi, most = 0.02 * truth;
    auto near = differences_of(found, [&](const FoundInRecord& each) { return is_near(each, truth) ? 100.0 : 0.0; });
    auto compliance = differences_of(found, [](const FoundInRecord& each) { return each.compliance_in3_per_psi; });
    auto generations = differences_of(found, [](const FoundInRecord& each) { return each.generations; });
    return {at_least(-5, difference_cell("last answer within 10 %", column, "% of records", near, 1)),
            at_most(most, at_least(-most, difference_cell("C_BOi", column, "in^3/psi", compliance, 5))),
            at_most(5, difference_cell("generations until within 10 %", column, "generations", generations, 1))};
}

Replay replay_parallel_identification(const ReplayContext& context, const ParallelExperiment& experiment) {
    std::vector<Comparison> comparisons;
    for (const RecordedBoom& machine : {simple_boom, measured_boom})
        for (Comparison& comparison : compare_on(context, machine, experiment.from))
            comparisons.push_back(std::move(comparison));
    return replay_of(std::move(comparisons), {{experiment.plot, plot_of_both(context, experiment)}});
}

} // namespace placedpar
