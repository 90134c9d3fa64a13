#include "experiments/chapter_5/kit/plant_study.hpp"
#include "experiments/kit/experiment.hpp"

#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr const char* by_turns = "sequential(every = 3)";

struct SequentialStudies {
    double noise;
    PlantStudy traditional, distributed, equal_cost, simulated;

    SequentialStudies(const ReplayContext& context, double sigma)
        : noise(sigma), traditional(study_plant(context, traditional_pga(by_turns, sigma))),
          distributed(study_plant(context, distributed_pga(by_turns, sigma))),
          equal_cost(study_plant(context, equal_cost_ga(sigma))),
          simulated(study_plant(context, simulated_in_window(distributed_pga(by_turns, sigma)))) {}

    std::vector<TrackRow> rows() const {
        return {{"traditional, island 0", &traditional}, {"distributed, window 30", &distributed},
                {"  window 24", &distributed, 1},        {"  window 16", &distributed, 2},
                {"  window 10", &distributed, 3},        {equal_cost.islands.name, &equal_cost},
                {"simulated, window 30", &simulated},    {"  simulated, window 10", &simulated, 3}};
    }
};

/// Tests the claim "The variance of the estimated parameter seemed to be reduced slightly ... no other indication of
/// any significant improvement". "Slightly" is taken to mean at most a third. "No significant improvement" is taken to
/// mean that the delay is at most ten generations shorter: a greater difference would be visible in a figure of 600
/// generations.
std::vector<Claim> claims_of(const SequentialStudies& studies, double noise) {
    auto delay = [](const PlantStudy& study) { return study.of(0, Tracking::delay_20); };
    auto deviation = [](const PlantStudy& study) { return study.of(0, Tracking::deviation_after); };
    return {{"deviation, distributed / traditional", "",
             ratio(deviation(studies.distributed), deviation(studies.traditional)), 0.67, 0.99,
             noise > 0 ? ClaimVerdict::fails : ClaimVerdict::holds},
            {"delay, traditional minus distributed",
             "generations",
             less(delay(studies.traditional), delay(studies.distributed)),
             {},
             10}};
}

/// Judges the delays by the delays over 240 other seeds.
Comparison judged_figures(const SequentialStudies& noiseless) {
    Comparison comparison{.name = "delay until 20 % of the change is followed, noiseless", .against = "known"};
    auto rows = noiseless.rows();
    for (auto [row, known] : {std::pair(0, 118), {1, 111}, {4, 66}, {5, 90}})
        comparison.add(judged_delay(rows[static_cast<std::size_t>(row)], known, 12));
    return comparison;
}

Replay replay_pga_1(const ReplayContext& context) {
    std::vector<Comparison> comparisons(1);
    Plot plot{"Figure 5.3: sequential exchange (experiment #1), " + median_of_seeds(context), {}};
    std::vector<Panel> traditional, distributed;
    for (double noise : {0.0, 0.3}) {
        SequentialStudies studies(context, noise);
        auto rows = studies.rows();
        if (noise == 0)
            comparisons.front() = judged_figures(studies);
        comparisons.push_back(tracks_comparison("medians, " + noise_name(noise), rows));
        comparisons.push_back(claims_comparison("claims, " + noise_name(noise), claims_of(studies, noise)));
        traditional.push_back(pole_panel("traditional, " + noise_name(noise), {rows[0], rows[5]}));
        distributed.push_back(
            pole_panel("distributed, each window, " + noise_name(noise), {rows[1], rows[2], rows[3], rows[4]}));
    }
    plot.panels = {traditional[0], traditional[1], distributed[0], distributed[1]};
    return replay_of(std::move(comparisons), {{"figure-5-3", plot}});
}

} // namespace

extern const Experiment pga_1_experiment{
    .name = "pga-1",
    .about = "islands that exchange in turns, with different windows and populations (Figure 5.3)",
    .chapter = "5",
    .number = 1,
    .run = replay_pga_1,
    .seeds = plant_seeds_of_claims,
};

} // namespace placedpar
