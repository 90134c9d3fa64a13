#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "hydraulics/plant/boom_control.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "report/cell.hpp"
#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// A fault of the simulated machine. A leak begins when the reference begins to rise. An offset or drift of the voltage
/// begins at time 0.
struct LoopFault {
    const char* name;
    double leak_in3_per_s_psi, bias_volts, drift_volts_per_s;
};
constexpr LoopFault sound_loop{"sound", 0, 0, 0};
constexpr std::array loop_leaks{LoopFault{"a leak of 0.002", 0.002, 0, 0}, LoopFault{"a leak of 0.004", 0.004, 0, 0}};
constexpr std::array loop_drifts{LoopFault{"-40 mV", 0, -0.040, 0}, LoopFault{"-20 mV", 0, -0.020, 0},
                                 LoopFault{"+20 mV", 0, 0.020, 0}, LoopFault{"+40 mV", 0, 0.040, 0},
                                 LoopFault{"10 mV/s", 0, 0, 0.010}};

constexpr double end_s = 4, judged_for_s = 1; // length of the motion; the position error is averaged over the last
                                              // second

struct LoopFigure {
    enum : std::size_t { steady_deg, greatest_deg, by_spool, by_servo, leak_share, count };
};

ControlledMotion run_loop(const LoopFault& fault, bool closed, std::uint64_t seed) {
    Parameters machine = Parameters::excavator();
    for (Parameter& row : noise_rows(machine, "low"))
        machine.put(std::move(row));
    MeasuredExcavator excavator = measured_excavator(machine);
    const BoomControl control = boom_control(machine);
    excavator.duration_s = end_s;
    excavator.leak = {fault.leak_in3_per_s_psi, control.step_time_s};
    excavator.voltage_spool.volts = {fault.bias_volts, fault.drift_volts_per_s};
    RandomStream sensors(seed, "sensors");
    return simulate_controlled(excavator, boom_sensors(machine), closed ? control : control.open_loop(),
                               [&] { return sensors.uniform(); });
}

/// Returns the angle by which the boom lags behind the reference.
double lag_deg(const MeasuredState& state) {
    const static MeasuredExcavator excavator = measured_excavator();
    return boom_control().desired_deg(state.time_s) - excavator.boom.joint_deg(state.piston_in);
}

/// Returns the compliance identified during the pressure rise, as in chapter 3.
double loop_compliance(const Record& record, AreasFrom from, std::uint64_t seed) {
    const Question question{Configuration::a, {Link::boom}, {}, from};
    const ComplianceSearch prepared = prepare(record, Parameters::excavator(), question, rising_way());
    return identify(prepared.problem, prepared.flow, prepared.samples, rising_way(), seed)
        .links.front()
        .compliance_in3_per_psi;
}

Figures figures_of_loop(const LoopFault& fault, bool closed, std::uint64_t seed) {
    const ControlledMotion motion = run_loop(fault, closed, seed);
    double steady = 0, greatest = 0, leak = 0, inlet = 0, states = 0;
    for (const MeasuredState& state : motion.states) {
        greatest = std::max(greatest, std::abs(lag_deg(state)));
        if (state.time_s < end_s - judged_for_s)
            continue;
        steady += lag_deg(state);
        leak += state.leak_in3_per_s;
        inlet += state.inlet_in3_per_s;
        states += 1;
    }
    return {steady / states, greatest, loop_compliance(motion.record, AreasFrom::spool, seed),
            loop_compliance(motion.record, AreasFrom::servo, seed), 100 * leak / inlet};
}

struct LoopRuns {
    std::string name;
    std::vector<Figures> closed, open;
};

LoopRuns run_both(const ReplayContext& context, const LoopFault& fault) {
    auto run = [&](bool closed) {
        return run_seeds(context, fmt::format("{}, {} loop", fault.name, closed ? "closed" : "open"),
                         [&, closed](std::uint64_t seed) { return figures_of_loop(fault, closed, seed); });
    };
    return {fault.name, run(true), run(false)};
}

/// Returns, for each seed, how much greater a figure is than with the sound machine.
std::vector<double> changes(const std::vector<Figures>& runs, const std::vector<Figures>& sound, std::size_t figure) {
    std::vector<double> all;
    for (std::size_t i = 0; i < runs.size(); ++i)
        all.push_back(runs[i][figure] - sound[i][figure]);
    return all;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values)
        value *= factor;
    return values;
}

void add_median(Comparison& comparison, std::string row, const std::string& column, const char* unit,
                const std::vector<double>& values, int decimals, std::optional<double> low = {},
                std::optional<double> high = {}) {
    Cell cell = plain_cell(row, column, unit, lower_median(values), decimals);
    cell.at_least = low;
    cell.at_most = high;
    comparison.add(cell);
    const Interval interval = median_interval(values);
    comparison.add(plain_cell("  from, " + row, column, unit, interval.low, decimals));
    comparison.add(plain_cell("  to, " + row, column, unit, interval.high, decimals));
}

constexpr double sound_in3_per_psi = 0.0086; // true boom.inlet_compliance

const std::vector<Figures>& runs_of(const LoopRuns& runs, bool closed) { return closed ? runs.closed : runs.open; }

std::string loop_column(const LoopRuns& runs, bool closed) {
    return fmt::format("{}, {}", runs.name, closed ? "closed" : "open");
}

/// Adds the increases of the position error and of the compliance that a leak causes, as medians over the seeds.
void add_leak(Comparison& comparison, const LoopRuns& sound, const LoopRuns& leak, bool closed) {
    const std::string name = loop_column(leak, closed);
    const std::vector<Figures>&runs = runs_of(leak, closed), &healthy = runs_of(sound, closed);
    comparison.add(
        plain_cell("leak as a share of the inflow", name, "%", lower_median_of(runs, LoopFigure::leak_share), 1));
    add_median(comparison, "lag behind the reference grows by", name, "deg",
               changes(runs, healthy, LoopFigure::steady_deg), 3);
    // By section 2.8, the identified compliance grows at least by the leak's flow divided by the slope of the pressure.
    add_median(comparison, "compliance grows by", name, "%",
               scaled(changes(runs, healthy, LoopFigure::by_spool), 100 / sound_in3_per_psi), 1, 5);
}

/// Compares the increases of the lag and of the compliance that a leak causes, in the open loop and in the closed loop.
Comparison leak_comparison(const LoopRuns& sound, const std::vector<LoopRuns>& leaks, std::size_t seeds) {
    Comparison comparison{
        .name = fmt::format("a leak: the lag that an operator sees, and the compliance identified; {} seeds", seeds),
        .notes =
            "the reference moves at 4 deg/s; lag: mean over the last second; from, to: 95 % interval of the median\n"
            "judged: the compliance grows by 5 % or more (a bound chosen here)\n",
        .against = "own"};
    for (const LoopRuns& leak : leaks)
        for (bool closed : {false, true})
            add_leak(comparison, sound, leak, closed);
    return comparison;
}

/// Judges the claim that the closed loop masks the leak. The judged figure is the lag that the leak adds in the closed
/// loop, divided by the lag that the leak adds in the open loop.
Comparison mask_comparison(const LoopRuns& sound, const std::vector<LoopRuns>& leaks) {
    Comparison comparison{.name = "the closed loop's additional lag as a share of the open loop's",
                          .notes = "judged: a quarter or less (a bound chosen here)\n",
                          .against = "own",
                          .judged = true};
    for (const LoopRuns& leak : leaks) {
        const Interval left = quotient_interval(changes(leak.closed, sound.closed, LoopFigure::steady_deg),
                                                changes(leak.open, sound.open, LoopFigure::steady_deg));
        const double share = mean(changes(leak.closed, sound.closed, LoopFigure::steady_deg)) /
                             mean(changes(leak.open, sound.open, LoopFigure::steady_deg));
        comparison.add(at_most(25, plain_cell("share", leak.name, "%", 100 * share, 1)));
        comparison.add(plain_cell("  from", leak.name, "%", 100 * left.low, 1));
        comparison.add(plain_cell("  to", leak.name, "%", 100 * left.high, 1));
    }
    return comparison;
}

void add_drift(Comparison& comparison, const LoopRuns& runs, bool closed) {
    const std::string name = loop_column(runs, closed);
    auto add = [&](const char* row, std::size_t figure, double scale, const char* unit, int decimals) {
        add_median(comparison, row, name, unit, scaled(column(runs_of(runs, closed), figure), scale), decimals);
    };
    add("lag, mean of the last second", LoopFigure::steady_deg, 1, "deg", 2);
    add("greatest position error", LoopFigure::greatest_deg, 1, "deg", 2);
    add("C by the spool", LoopFigure::by_spool, 1000, "0.001 in^3/psi", 2);
    add("C by the voltage", LoopFigure::by_servo, 1000, "0.001 in^3/psi", 2);
}

Comparison drift_comparison(const LoopRuns& sound, const std::vector<LoopRuns>& drifts, bool closed) {
    Comparison comparison{
        .name = fmt::format("the servo-valve's voltage has an offset or drifts, {} loop", closed ? "closed" : "open"),
        .notes = "20 mV move the spool by 0.01 in; the true C is 0.0086 in^3/psi\n",
        .against = "own"};
    add_drift(comparison, sound, closed);
    for (const LoopRuns& drift : drifts)
        add_drift(comparison, drift, closed);
    return comparison;
}

Series lag_series(const LoopFault& fault, bool closed, std::string name, int colour, std::uint64_t seed) {
    Series series{std::move(name), {}, closed ? Stroke::line : Stroke::dashes, colour};
    const ControlledMotion motion = run_loop(fault, closed, seed);
    const std::size_t stride = motion.states.size() / 100;
    for (std::size_t i = 0; i < motion.states.size(); i += stride)
        series.points.push_back({motion.states[i].time_s, lag_deg(motion.states[i])});
    return series;
}

Panel lag_panel(std::string title, const std::vector<LoopFault>& faults, std::uint64_t seed) {
    Panel panel{std::move(title), {"time [s]", 0, end_s}, {"lag behind the reference [deg]"}, {}};
    int colour = 0;
    for (const LoopFault& fault : faults) {
        for (bool closed : {true, false})
            panel.series.push_back(
                lag_series(fault, closed, fmt::format("{}, {}", fault.name, closed ? "closed" : "open"), colour, seed));
        ++colour;
    }
    return panel;
}

Panel compliance_panel(const LoopRuns& sound, const std::vector<LoopRuns>& leaks) {
    Panel panel{"Identified compliance, median and 95 % interval",
                {"leak [0.001 in³/(s psi)]", -0.5, 4.5},
                {"C_BOi [0.001 in³/psi]", 8, 13},
                {}};
    for (bool closed : {true, false}) {
        Series series{closed ? "closed loop" : "open loop", {}, Stroke::points, closed ? 0 : 1};
        auto add = [&](double leak, const LoopRuns& runs) {
            const std::vector<double> found = scaled(column(runs_of(runs, closed), LoopFigure::by_spool), 1000);
            series.points.push_back({leak, lower_median(found)});
            series.intervals.push_back(median_interval(found));
        };
        add(0, sound);
        for (std::size_t i = 0; i < leaks.size(); ++i)
            add(1000 * loop_leaks[i].leak_in3_per_s_psi, leaks[i]);
        panel.series.push_back(std::move(series));
    }
    panel.marks = {{"true", 1000 * sound_in3_per_psi}};
    return panel;
}

Replay replay_closed_loop(const ReplayContext& context) {
    const LoopRuns sound = run_both(context, sound_loop);
    std::vector<LoopRuns> leaks, drifts;
    for (const LoopFault& leak : loop_leaks)
        leaks.push_back(run_both(context, leak));
    for (const LoopFault& drift : loop_drifts)
        drifts.push_back(run_both(context, drift));
    const Plot plot{"A closed loop masks a leak",
                    {lag_panel("Position error, a leak from 0.1 s on", {sound_loop, loop_leaks.back()}, context.seed),
                     compliance_panel(sound, leaks),
                     lag_panel("Position error, the servo-valve's voltage 40 mV too low or too high",
                               {loop_drifts.front(), loop_drifts[3]}, context.seed)}};
    Replay replay = replay_of({leak_comparison(sound, leaks, context.seeds), mask_comparison(sound, leaks),
                               drift_comparison(sound, drifts, false), drift_comparison(sound, drifts, true)},
                              {{"closed-loop", plot}});
    replay.constants = "the gains K_p and K_v are calibrated, because the thesis states none; the speed of 4 deg/s is "
                       "published (thesis 3.1.2)\n";
    return replay;
}

} // namespace

extern const Experiment closed_loop_experiment{
    .name = "closed-loop",
    .about = "how a closed loop masks a leak, and what a drift of the servo-valve's voltage does (2.3.2)",
    .chapter = "2",
    .number = 5,
    .run = replay_closed_loop,
    .seeds = 60,
};

} // namespace placedpar
