#include "experiments/chapter_3/kit/two_link_plots.hpp"
#include "experiments/chapter_3/kit/two_link_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/record_seeds.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr std::size_t samples_in_figure_3_9 = 84; // 20 ms each, from the valves' opening to 2 s

/// Compares the steady state of scenario R2 with the steady state in an independent prototype.
Comparison steady_comparison(const TwoLinkMotion& motion) {
    const ExcavatorState& end = motion.motion.states.back();
    InternalStates states = true_states(end);
    Comparison comparison{.name = "scenario R2, simulated (Figure 3.9): states when the motion is steady",
                          .against = "known",
                          .judged = true};
    auto add = [&](const char* row, const char* unit, double known, double value) {
        comparison.add(judged_cell(row, "t = 4 s", unit, known, value, 0.005 * known, 1));
    };
    add("P_11", "psi", 2051, states.p11);
    add("P_12", "psi", 1722, states.p12);
    add("P_BUi", "psi", 2024, end.links[0].inlet_psi);
    add("P_BOi", "psi", 1687, end.links[1].inlet_psi);
    add("Q_11", "in^3/s", 123.2, states.q11);
    add("Q_12", "in^3/s", 66.0, states.q12);
    add("Q_BUi", "in^3/s", 51.9, states.q_bucket);
    add("Q_BOi", "in^3/s", 57.2, states.q_boom);
    return comparison;
}

/// A way of searching at one noise level, and its known success rate.
struct TwoLinkCase {
    const char* name;
    IdentificationWay way;
    MeasurementNoise noise;
    double known_percent; ///< the prototype's percentage of records with both errors within 10 %
};

void add_study(Comparison& comparison, const TwoLinkCase& study, const TwoLinkMotion& motion, const Seeds& seeds) {
    auto runs = search_many(motion, study.noise, study.way, seeds);
    std::vector<double> bucket, boom;
    for (const SearchRun& run : runs) {
        TwoErrors errors = errors_of(run.estimates.back().compliance_in3_per_psi);
        bucket.push_back(errors.bucket);
        boom.push_back(errors.boom);
    }
    std::size_t last = runs.front().estimates.size() * study.way.search.window.trials;
    double within = both_within_ten_percent(runs, last, study.way.search.window.trials);
    double least = study.known_percent - share_tolerance(study.known_percent, seeds.size());
    Cell shared = compared_cell("both within 10 %", study.name, "% of records", study.known_percent, within, 0);
    comparison.add(at_least(least, shared));
    auto add = [&](const char* row, double value) { comparison.add(plain_cell(row, study.name, "%", value, 1)); };
    add("error of C_BUi, median", lower_median(bucket));
    add("  of C_BUi, 9 of 10 below", quantile(bucket, 0.9));
    add("error of C_BOi, median", lower_median(boom));
    add("  of C_BOi, 9 of 10 below", quantile(boom, 0.9));
}

Comparison study_comparison(const TwoLinkMotion& motion, const Seeds& seeds) {
    Comparison comparison{
        .name = fmt::format("C_BUi and C_BOi found together, {} records, 20 samples of 5 generations", seeds.size()),
        .notes = "judged: at least the known share minus four standard deviations of the difference between two such "
                 "samples of records\n",
        .against = "known"};
    add_study(comparison, {"as the thesis has it", thesis_way(), no_noise, 65}, motion, seeds);
    add_study(comparison, {"elite, 2 skipped", elite_way(), no_noise, 98}, motion, seeds);
    add_study(comparison, {"and Gray code", gray_way(), no_noise, 100}, motion, seeds);
    return comparison;
}

Comparison noise_comparison(const TwoLinkMotion& motion, const Seeds& seeds) {
    Comparison comparison{.name = "C_BUi and C_BOi found together at low noise (2 psi, .003 deg, .1 % of an area)",
                          .against = "known",
                          .judged = true};
    add_study(comparison, {"as the thesis has it", thesis_way(), low_noise, 55}, motion, seeds);
    add_study(comparison, {"elite, 2 skipped", elite_way(), low_noise, 80}, motion, seeds);
    add_study(comparison, {"and Gray code", gray_way(), low_noise, 86}, motion, seeds);
    return comparison;
}

using StateErrors = std::array<double, InternalStates::count>;

/// Returns the greatest error of each state in one search, in percent, from the sixth sample on. Earlier answers are
/// left out, because the search has not converged: the first answer is found after only five generations on five
/// samples.
StateErrors worst_errors(const TwoLinkMotion& motion, const IdentificationWay& way, std::uint64_t seed) {
    const auto [prepared, run] = search_two_links(motion, no_noise, way, seed);
    StateErrors worst{};
    for (const TransientEstimate& estimate : run.estimates) {
        if (estimate.time_s < prepared.samples.front().time_s + 0.099)
            continue;
        auto sample = std::ranges::find(prepared.samples, estimate.index, &CircuitSample::index);
        auto found = estimated_states(*sample, estimate.compliance_in3_per_psi, prepared.flow).values();
        auto state =
            std::ranges::lower_bound(motion.motion.states, estimate.time_s - 1e-9, {}, &ExcavatorState::time_s);
        auto truth = true_states(*state).values();
        for (std::size_t i = 0; i < found.size(); ++i)
            worst[i] = std::max(worst[i], 100 * std::abs(found[i] / truth[i] - 1));
    }
    return worst;
}

/// Tests the thesis's claim "states within 10 %".
Comparison states_comparison(const TwoLinkMotion& motion, std::uint64_t seed) {
    constexpr std::array<const char*, InternalStates::count> names{"P_11", "P_12", "Q_11", "Q_12", "Q_BUi", "Q_BOi"};
    Comparison comparison{.name = "internal states from the best individual (Figure 3.10): greatest error from the "
                                  "sixth sample on, of one search without noise",
                          .notes = "judged: the search with an elite, the first two samples skipped, and Gray code; in "
                                   "the thesis's search, chance decides\n",
                          .against = "thesis",
                          .judged = true};
    StateErrors gray = worst_errors(motion, gray_way(), seed), plain = worst_errors(motion, thesis_way(), seed);
    for (std::size_t i = 0; i < names.size(); ++i) {
        comparison.add(plain_cell(names[i], "as the thesis has it", "%", plain[i], 1));
        comparison.add(at_most(10, plain_cell(names[i], "elite, 2 skipped, Gray", "%", gray[i], 1)));
    }
    return comparison;
}

/// Plots one search without noise over the whole time of Figure 3.9. When the motion is steady, the samples do not
/// determine the compliances. The gate (ExcitationGate) then stops the search, and the last estimate is kept.
Plot plot_of_found_states(const TwoLinkMotion& motion, std::uint64_t seed) {
    IdentificationWay way = gray_way();
    way.usable.count = samples_in_figure_3_9;
    way.gate.emplace();
    const TwoLinkSearch found = search_two_links(motion, no_noise, way, seed);
    return plot_of_estimated_states(motion, found.prepared, found.run);
}

Replay replay_figures_3_9_to_3_11(const ReplayContext& context) {
    context.progress("bucket and boom, simulated");
    TwoLinkMotion motion = simulate_two_links();
    Seeds seeds = record_seeds(context.seed, search_records);
    context.progress("bucket and boom, identified");
    return replay_of(
        {study_comparison(motion, seeds), steady_comparison(motion), states_comparison(motion, seeds.front()),
         noise_comparison(motion, seeds)},
        {{"figure-3-9", plot_of_states(motion)}, {"figure-3-10", plot_of_found_states(motion, seeds.front())}});
}

} // namespace

extern const Experiment figures_3_9_to_3_11_experiment{
    .name = "figures-3-9-to-3-11",
    .about = "one search for the compliances of bucket and boom, and the states inside the valve",
    .chapter = "3",
    .number = 5,
    .run = replay_figures_3_9_to_3_11,
};

} // namespace placedpar
