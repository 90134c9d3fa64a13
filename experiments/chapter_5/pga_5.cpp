#include "experiments/chapter_5/kit/plant_study.hpp"
#include "experiments/kit/experiment.hpp"

#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

struct RivalStudies {
    double noise;
    PlantStudy islands, single, equal_cost;

    RivalStudies(const ReplayContext& context, double sigma)
        : noise(sigma), islands(study_plant(context, configured(sigma))),
          single(study_plant(context, single_ga(sigma))), equal_cost(study_plant(context, equal_cost_ga(sigma))) {}

    std::vector<TrackRow> rows() const {
        std::vector<TrackRow> rows;
        for (const std::string& choice : islands.islands.choices)
            rows.push_back({"islands, " + choice, &islands, islands.answer(choice)});
        rows.push_back({single.islands.name, &single});
        rows.push_back({equal_cost.islands.name, &equal_cost});
        return rows;
    }

private:
    static PlantIslands configured(double sigma) {
        PlantIslands islands = distributed_pga("broadcast(every = 12)", sigma);
        islands.choices = {"printed", "row", "random"};
        return islands;
    }
};

/// Tests the claim "Actually outperformed GA in tracking parameter changes and had smaller variance". The claim is
/// taken to mean that the lag is at least ten generations shorter, which is visible in a figure, and that the deviation
/// is smaller. The rule "row" is expected to track better than the genetic algorithm of the thesis, but not better than
/// a genetic algorithm of equal cost. With "row" the deviation is expected to be smaller only at low noise.
void add_claims(std::vector<Claim>& claims, const RivalStudies& studies, const std::string& rule,
                const PlantStudy& rival) {
    const bool is_row = rule == "row", is_of_equal_cost = &rival == &studies.equal_cost;
    const double too_noisy = is_of_equal_cost ? 1 : 0.3;
    auto holds_if = [](bool expected) { return expected ? ClaimVerdict::holds : ClaimVerdict::fails; };
    std::size_t answer = studies.islands.answer(rule);
    auto of = [&](Tracking figure) { return studies.islands.of(answer, figure); };
    claims.push_back({"lag, " + rival.islands.name + " minus islands, " + rule,
                      "generations",
                      less(rival.of(0, Tracking::lag), of(Tracking::lag)),
                      10,
                      {},
                      holds_if(is_row && !is_of_equal_cost)});
    claims.push_back({"deviation, islands, " + rule + " by " + rival.islands.name,
                      "",
                      ratio(of(Tracking::deviation_after), rival.of(0, Tracking::deviation_after)),
                      {},
                      0.99,
                      holds_if(!is_row || rival.islands.plant.noise < too_noisy)});
}

std::vector<Claim> claims_of(const RivalStudies& studies) {
    std::vector<Claim> claims;
    for (const char* rule : {"printed", "row"})
        for (const PlantStudy* rival : {&studies.single, &studies.equal_cost})
            add_claims(claims, studies, rule, *rival);
    return claims;
}

/// Judges the single genetic algorithm by the results of an independent prototype.
Comparison judged_single(const RivalStudies& noiseless) {
    Comparison comparison{.name = "the genetic algorithm of 100 with window 30, noiseless", .against = "known"};
    auto median = [&](Tracking figure) { return noiseless.single.median(0, figure); };
    comparison.add(judged_cell("delay to 20 %", "median", "generations", 114, median(Tracking::delay_20), 10, 1));
    comparison.add(judged_cell("lag", "median", "generations", 86, median(Tracking::lag), 10, 1));
    comparison.add(at_most(0.03, plain_cell("error before", "median", "", median(Tracking::error_before), 4)));
    return comparison;
}

void add_panels(Plot& plot, const RivalStudies& studies) {
    auto rows = studies.rows();
    plot.panels.push_back(pole_panel("GA, " + noise_name(studies.noise), {rows[3], rows[4]}));
    plot.panels.push_back(pole_panel("islands, " + noise_name(studies.noise), {rows[0], rows[1], rows[2]}));
}

Replay replay_pga_5(const ReplayContext& context) {
    std::vector<Comparison> comparisons(1);
    Plot plot{"Figure 5.7: islands beside one genetic algorithm (experiment #5), " + median_of_seeds(context), {}};
    for (double noise : {0.0, 0.1, 0.3, 1.0}) {
        RivalStudies studies(context, noise);
        if (noise == 0)
            comparisons.front() = judged_single(studies);
        comparisons.push_back(tracks_comparison("medians, " + noise_name(noise), studies.rows()));
        comparisons.push_back(claims_comparison("claims, " + noise_name(noise), claims_of(studies)));
        if (noise == 0 || noise == 0.3)
            add_panels(plot, studies);
    }
    return replay_of(std::move(comparisons), {{"figure-5-7", plot}});
}

} // namespace

extern const Experiment pga_5_experiment{
    .name = "pga-5",
    .about = "islands with active error analysis beside one genetic algorithm (Figure 5.7)",
    .chapter = "5",
    .number = 5,
    .run = replay_pga_5,
    .seeds = plant_seeds_of_claims,
};

} // namespace placedpar
