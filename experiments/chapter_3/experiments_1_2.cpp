#include "experiments/chapter_3/boom_plots.hpp"
#include "experiments/chapter_3/boom_search.hpp"
#include "experiments/chapter_3/spool_lag.hpp"
#include "experiments/kit/cells.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/record_seeds.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "identification/compliance_fit.hpp"
#include "identification/statistics.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

// As printed by the thesis.
constexpr double by_spool_in3_per_psi = 0.005, by_voltage_in3_per_psi = 0.0086;

constexpr double shown_s = 1.2; // of the plots

/// One of the thesis's two experiments.
struct Way {
    const char* name;
    AreasFrom from;
};
constexpr std::array<Way, 2> ways{{{"1: spool", AreasFrom::spool}, {"2: voltage", AreasFrom::servo}}};

/// A plant, and the noise of its sensors.
struct Source {
    const char* name;
    BoomPlant plant;
    MeasurementNoise noise;
};
constexpr Source simple{"simple plant, low noise", BoomPlant::simple, low_noise};
constexpr Source simple_clean{"simple plant, no noise", BoomPlant::simple, no_noise};
constexpr Source measured{"measured machine, mid noise", BoomPlant::measured, mid_noise};

BoomMotion motion_of(const Source& source, double compliance_in3_per_psi) {
    BoomMotion motion{source.plant, source.noise};
    motion.inlet_compliance_in3_per_psi = compliance_in3_per_psi;
    return motion;
}

/// What the searches find, each with random numbers of its own.
std::vector<double> found_in(const std::vector<BoomData>& motions, const BoomModel& model, const Seeds& seeds) {
    std::vector<double> found;
    for (std::size_t i = 0; i < motions.size(); ++i)
        found.push_back(identify_boom(motions[i], model, rising_way(), seeds[i]).compliance_in3_per_psi);
    return found;
}

/// The rms error that the best of all codes leaves in each window that the search saw.
std::vector<double> least_errors(const BoomData& data, std::span<const CircuitSample> samples,
                                 const IdentificationWay& way) {
    std::vector<double> errors;
    for (std::size_t last = way.search.window.first; last <= samples.size(); ++last) {
        std::size_t length = std::min(last, way.search.window.length);
        auto window = samples.subspan(last - length, length);
        auto best = exhaustive_optimum(boom_circuit(), window, data.flow, printed_inlet_flow(1), way.bits,
                                       CircuitProblem::largest_in3_per_psi, way.search.window.bias);
        double square = way.search.window.bias - best.fitness / static_cast<double>(length);
        errors.push_back(std::sqrt(std::max(square, 0.0)));
    }
    return errors;
}

std::vector<CircuitSample> samples_while_rising(const BoomData& data, const BoomModel& model) {
    return usable_samples(samples_of(data, model), boom_circuit(), data.flow, rising_way().usable);
}

std::size_t rises(const std::vector<double>& values) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        count += values[i] > values[i - 1];
    return count;
}

double within_percent_of(const std::vector<double>& found, double truth, double percent) {
    std::vector<double> errors;
    for (double each : found)
        errors.push_back(100 * std::abs(each / truth - 1));
    return percent_within(errors, percent);
}

/// What the Error does while the search is active.
void add_errors(Reading& reading, const Way& way, const BoomData& data, std::uint64_t seed) {
    BoomModel model = model_of(data, way.from);
    auto identified = identify_boom(data, model, rising_way(), seed);
    auto generations = watch_search(data, identified.samples, rising_way(), seed);
    auto add = [&](const char* row, double value) {
        reading.cells.push_back(plain_cell(row, way.name, "in^3/s", value, 2));
    };
    add("Error, mean of the population, first", generations.front().mean_error_in3_per_s);
    add("  last generation", generations.back().mean_error_in3_per_s);
    add("Error of the best individual, first", generations.front().best_error_in3_per_s);
    add("  of the last generation", generations.back().best_error_in3_per_s);
}

/// The thesis's "decreasing monotonically", where noise does not hide it: of the best of all codes in every window.
void add_clean_errors(Reading& reading, const Way& way, const BoomData& clean) {
    auto samples = samples_while_rising(clean, model_of(clean, way.from));
    auto least = least_errors(clean, samples, rising_way());
    reading.cells.push_back(plain_cell("Error without noise, best code, first", way.name, "in^3/s", least.front(), 2));
    reading.cells.push_back(plain_cell("  last window", way.name, "in^3/s", least.back(), 2));
    reading.cells.push_back(
        judged_cell("  how often it rises", way.name, "", 0, static_cast<double>(rises(least)), 0, 0));
}

/// How far an experiment's compliance may be from the true one, as a share of it: for one record, for the median of
/// many.
struct Allowed {
    double record, median;
};

void add_found(Reading& reading, const Way& way, const std::vector<BoomData>& motions, const Seeds& seeds,
               const Allowed& allowed) {
    BoomModel model = model_of(motions.front(), way.from);
    double truth = motions.front().machine.inlet_compliance_in3_per_psi;
    auto one = identify_boom(motions.front(), model, rising_way(), seeds.front());
    auto found = found_in(motions, model, seeds);
    auto add = [&](const char* row, double value, double tolerance) {
        reading.cells.push_back(judged_cell(row, way.name, "in^3/psi", truth, value, tolerance * truth, 5));
    };
    add("C_BOi of this record", one.compliance_in3_per_psi, allowed.record);
    reading.cells.push_back(
        compared_cell("  least squares", way.name, "in^3/psi", truth, one.least_squares.value_or(0), 5));
    add("  median of 50 records", quantile(found, 0.5), allowed.median);
    reading.cells.push_back(plain_cell("  records within 10 %", way.name, "%", within_percent_of(found, truth, 10), 0));
}

Reading simple_reading(const std::vector<BoomData>& motions, const Seeds& seeds) {
    Reading reading{fmt::format("{}: what both experiments find", simple.name), {}, "", "true"};
    BoomData clean = measure(motion_of(simple_clean, by_voltage_in3_per_psi), seeds.front());
    for (const Way& way : ways)
        add_found(reading, way, motions, seeds, {0.1, 0.03});
    for (const Way& way : ways) {
        add_errors(reading, way, motions.front(), seeds.front());
        add_clean_errors(reading, way, clean);
    }
    return reading;
}

/// The model knows nothing of the measured machine's hoses, stiction and ripple, nor of 10 ms of dead time, which in
/// experiment 2 act as an a_0 that is too high.
Reading measured_reading(const std::vector<BoomData>& motions, const Seeds& seeds) {
    Reading reading{fmt::format("{}: what both experiments find", measured.name), {}, "", "true", true};
    for (const Way& way : ways)
        add_found(reading, way, motions, seeds, way.from == AreasFrom::spool ? Allowed{0.12, 0.03} : Allowed{0.2, 0.1});
    for (const Way& way : ways)
        add_errors(reading, way, motions.front(), seeds.front());
    return reading;
}

/// What experiment 2 finds with another a_0 than the machine's 8; the known errors are an independent prototype's.
struct WrongLag {
    double lag_per_s, known_percent;
};
constexpr std::array<WrongLag, 5> wrong_lags{{{6, -59}, {7.5, -12}, {8, 0}, {8.5, 12}, {10, 39}}};

Reading lag_reading(const std::vector<BoomData>& motions, const Seeds& seeds) {
    double truth = motions.front().machine.inlet_compliance_in3_per_psi;
    Reading reading{
        "simple plant, experiment 2 with another a_0 than the machine's 8: error of C_BOi, median of 50 records",
        {},
        "",
        "known",
        true};
    for (const WrongLag& lag : wrong_lags) {
        BoomModel model{AreasFrom::servo, lag.lag_per_s, 0};
        auto percent = [&](double found) { return 100 * (found / truth - 1); };
        std::string column = fmt::format("a_0 = {}", lag.lag_per_s);
        double searched = quantile(found_in(motions, model, seeds), 0.5);
        reading.cells.push_back(judged_cell("search", column, "%", lag.known_percent, percent(searched), 8, 1));
        auto fit = least_squares_compliance(motions.front(), model, rising_way().usable);
        reading.cells.push_back(plain_cell("least squares, one record", column, "%", percent(fit.value_or(0)), 1));
    }
    return reading;
}

/// .005 and .0086 of one machine: an a_0 believed to be higher than it is, or a spool that reads too low.
Reading both_reading(const Seeds& seeds) {
    BoomData clean = measure(motion_of(simple_clean, by_spool_in3_per_psi), seeds.front());
    double lag = lag_that_finds(by_voltage_in3_per_psi, clean);
    auto softer = measure(motion_of(simple, by_spool_in3_per_psi), seeds);
    BoomData stiff = measure(motion_of(simple_clean, by_voltage_in3_per_psi), seeds.front());
    double low = offset_that_finds(by_spool_in3_per_psi, stiff);
    auto motions = measure(motion_of(simple, by_voltage_in3_per_psi), seeds);
    Reading reading{"simple plant: .005 versus .0086 of one machine, median of 50 records", {}, "", "thesis", true};
    auto add = [&](const std::string& row, const Way& way, double figure, double value, Origin origin) {
        Cell cell = judged_cell(row, way.name, "in^3/psi", figure, value, 0.05 * figure, 5);
        cell.origin = origin;
        reading.cells.push_back(cell);
    };
    auto found = [&](const std::vector<BoomData>& data, const BoomModel& model) {
        return quantile(found_in(data, model, seeds), 0.5);
    };
    std::string wrong_lag = fmt::format("true C .005, a_0 8 taken for {:.2f}", lag);
    add(wrong_lag, ways[0], by_spool_in3_per_psi, found(softer, model_of(clean, AreasFrom::spool)), Origin::outcome);
    add(wrong_lag, ways[1], by_voltage_in3_per_psi, found(softer, {AreasFrom::servo, lag, 0}), Origin::calibrated);
    std::string wrong_spool = fmt::format("true C .0086, spool reads {:.4f} in low", -low);
    // Taking too much off the readings is the same as a sensor that reads too low.
    BoomModel low_model = model_of(stiff, AreasFrom::spool);
    low_model.spool_offset_in = -low;
    add(wrong_spool, ways[0], by_spool_in3_per_psi, found(motions, low_model), Origin::calibrated);
    add(wrong_spool, ways[1], by_voltage_in3_per_psi, found(motions, model_of(stiff, AreasFrom::servo)),
        Origin::outcome);
    reading.notes = fmt::format("c: the {:.0f} % of a_0 and the {:.4f} in of spool were chosen for it\n",
                                100 * (lag / clean.machine.spool_lag_per_s - 1), -low);
    return reading;
}

std::vector<NamedPlot> plots_of(const BoomData& data, std::uint64_t seed) {
    std::vector<NamedPlot> plots{
        {"figure-3-3",
         plot_of_record(fmt::format("Figure 3.3: data record, 4 deg/s, of the {}", measured.name), data, shown_s)}};
    for (const Way& way : ways) {
        BoomModel model = model_of(data, way.from);
        auto identified = identify_boom(data, model, rising_way(), seed);
        auto generations = watch_search(data, identified.samples, rising_way(), seed);
        bool first = way.from == AreasFrom::spool;
        std::string title = first ? "Figure 3.5: experiment 1, areas from the spool"
                                  : "Figure 3.6: experiment 2, areas from the servo-valve's voltage";
        plots.push_back({first ? "figure-3-5" : "figure-3-6",
                         plot_of_identification({title, data, model, identified, generations}, shown_s)});
    }
    std::array machines{measure(motion_of(simple_clean, by_spool_in3_per_psi), seed),
                        measure(motion_of(simple_clean, by_voltage_in3_per_psi), seed)};
    plots.push_back({"spool-lag", {"Why .005 versus .0086: what an error of a_0 does", {panel_of_lag(machines)}}});
    return plots;
}

} // namespace

Replay replay_experiments_1_2(const ReplayContext& context) {
    Seeds seeds = record_seeds(context.seed, usual_records);
    context.progress(simple.name);
    auto motions = measure(motion_of(simple, by_voltage_in3_per_psi), seeds);
    Replay replay;
    replay.readings.push_back(simple_reading(motions, seeds));
    context.progress(measured.name);
    auto measured_motions = measure(motion_of(measured, by_voltage_in3_per_psi), seeds);
    replay.readings.push_back(measured_reading(measured_motions, seeds));
    context.progress("another a_0");
    replay.readings.push_back(lag_reading(motions, seeds));
    replay.readings.push_back(both_reading(seeds));
    replay.fingerprint = fingerprint_of(replay.readings);
    replay.plots = plots_of(measured_motions.front(), seeds.front());
    return replay;
}

} // namespace placedpar
