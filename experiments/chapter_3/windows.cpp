#include "experiments/chapter_3/kit/boom_search.hpp"
#include "experiments/kit/claims.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr std::size_t lengths[]{3, 5, 7, 10, 15, 20, 30, 60};
constexpr std::size_t thesis_length = 3; // index of 10 in `lengths`

struct WindowPlant {
    const char* name;
    BoomPlant plant;
    MeasurementNoise noise;
};

constexpr WindowPlant plants[]{{"simple plant, low noise", BoomPlant::simple, low_noise},
                               {"measured machine, low noise", BoomPlant::measured, low_noise},
                               {"measured machine, mid noise", BoomPlant::measured, mid_noise},
                               {"measured machine, high noise", BoomPlant::measured, high_noise}};

/// Returns the settings of the thesis's search with another window. The search uses 20 samples, as in the thesis, or
/// more if the window is longer.
IdentificationWay way_of(std::size_t length) {
    IdentificationWay way = thesis_way();
    way.search.window.length = length;
    way.search.window.first = std::min(way.search.window.first, length);
    way.usable.count = std::max(way.usable.count, length);
    return way;
}

/// Returns the error of the last answer in percent of the true compliance, for each length.
Figures errors_of(const WindowPlant& plant, std::uint64_t seed) {
    const BoomData data = measure({.plant = plant.plant, .noise = plant.noise}, seed);
    Figures errors;
    for (std::size_t length : lengths) {
        double found =
            identify_boom(data, model_of(data, AreasFrom::spool), way_of(length), seed).compliance_in3_per_psi;
        errors.push_back(100 * std::abs(found / data.boom.inlet_compliance_in3_per_psi - 1));
    }
    return errors;
}

std::string name_of_window(std::size_t length) { return fmt::format("window of {}", length); }

Comparison errors_table(const WindowPlant& plant, const std::vector<Figures>& runs) {
    Comparison comparison{.name = plant.name, .against = "known"};
    for (std::size_t i = 0; i < std::size(lengths); ++i) {
        const std::vector<double> errors = column(runs, i);
        auto add = [&](const char* name, double value, int decimals) {
            comparison.add(plain_cell(name_of_window(lengths[i]), name, "", value, decimals));
        };
        add("error, median [%]", median(errors), 2);
        add("90th percentile [%]", quantile(errors, 0.9), 2);
        add("seeds within 10 % [%]", percent_within(errors, 10), 0);
    }
    return comparison;
}

/// Returns, for each seed, the error with this window minus the error with the thesis's window.
std::vector<double> excess(const std::vector<Figures>& runs, std::size_t window) {
    std::vector<double> differences;
    for (const Figures& errors : runs)
        differences.push_back(errors[window] - errors[thesis_length]);
    return differences;
}

/// Tests the claim "From trial and error in the experiments, 10 was found to be the best window size" (3.4), taken to
/// mean "no other window has a smaller error in the same record". The claim is expected to fail for longer windows.
Comparison best_window_claims(const WindowPlant& plant, const std::vector<Figures>& runs) {
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < std::size(lengths); ++i)
        if (i != thesis_length)
            claims.push_back({.text = fmt::format("error, window of {} less window of 10", lengths[i]),
                              .unit = "% of C",
                              .values = excess(runs, i),
                              .at_least = 0,
                              .at_most = {},
                              .expected = i > thesis_length ? ClaimVerdict::fails : ClaimVerdict::holds});
    return claims_comparison(fmt::format("the best window is 10, {}", plant.name), claims);
}

Series median_errors(const WindowPlant& plant, const std::vector<Figures>& runs) {
    Series series{plant.name, {}};
    for (std::size_t i = 0; i < std::size(lengths); ++i)
        series.points.push_back({static_cast<double>(lengths[i]), median(column(runs, i))});
    return series;
}

Replay replay_windows(const ReplayContext& context) {
    std::vector<Comparison> tables, claims;
    Panel panel;
    panel.title = fmt::format("error of the compliance, median of {} records", context.seeds);
    panel.x = {"samples in the window", 0, 60};
    panel.y = {"error [%]", 0, 12};
    for (const WindowPlant& plant : plants) {
        auto runs = run_seeds(context, plant.name, [&](std::uint64_t seed) { return errors_of(plant, seed); });
        claims.push_back(best_window_claims(plant, runs));
        tables.push_back(errors_table(plant, runs));
        panel.series.push_back(median_errors(plant, runs));
    }
    std::ranges::move(tables, std::back_inserter(claims));
    return replay_of(std::move(claims), {{"windows", {"Which window identifies best?", {panel}}}});
}

} // namespace

extern const Experiment windows_experiment{
    .name = "windows",
    .about = "errors with windows of 3 to 60 samples on the simulated machines: is 10 the best (3.4)?",
    .chapter = "3",
    .number = 11,
    .run = replay_windows,
    .seeds = 60,
};

} // namespace placedpar
