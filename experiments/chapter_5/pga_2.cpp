#include "experiments/chapter_5/kit/plant_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "text/statistics.hpp"

#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr const char* every_generation = "broadcast(every = 1)";

PlantIslands with_sizes(const char* name, const std::vector<std::size_t>& populations,
                        const std::vector<std::size_t>& windows, double noise) {
    return sized(traditional_pga(every_generation, noise), name, populations, windows);
}

/// The studies of four kinds of islands. `distributed` differs from `traditional` in populations and windows, `larger`
/// only in populations, and `windows` only in windows.
struct BroadcastStudies {
    PlantStudy traditional, larger, windows, distributed;

    BroadcastStudies(const ReplayContext& context, double noise)
        : traditional(study_plant(context, traditional_pga(every_generation, noise))),
          larger(study_plant(
              context, with_sizes("larger populations, equal windows", distributed_populations, equal_windows, noise))),
          windows(study_plant(context, with_sizes("equal populations, different windows", equal_populations,
                                                  distributed_windows, noise))),
          distributed(study_plant(context, distributed_pga(every_generation, noise))) {}

    std::vector<const PlantStudy*> all() const { return {&traditional, &larger, &windows, &distributed}; }
};

/// Tests two statements of the thesis. On the traditional islands: "The estimated poles from two different local GAs
/// became identical and converged prematurely". On islands with the distributed fitness function: "close but remained
/// different ... no indication of premature convergence".
std::vector<Claim> claims_of(const BroadcastStudies& studies, double noise) {
    auto error = [](const PlantStudy& study) { return study.of(0, Tracking::error_after); };
    return {{"traditional: generations in which both bests agree",
             "share",
             studies.traditional.identical,
             0.9,
             {},
             noise > 0 ? ClaimVerdict::fails : ClaimVerdict::holds},
            {"traditional: error of the pole after the change",
             "",
             error(studies.traditional),
             found_pole,
             {},
             ClaimVerdict::fails},
            {"distributed: generations in which both bests agree", "share", studies.distributed.identical, {}, 0.5},
            {"distributed: error of the pole after the change", "", error(studies.distributed), {}, found_pole},
            {"diversity, distributed minus traditional",
             "bits",
             less(studies.distributed.diversity, studies.traditional.diversity),
             0.5,
             {}},
            {"diversity, larger populations minus traditional",
             "bits",
             less(studies.larger.diversity, studies.traditional.diversity),
             0.5,
             {}},
            {"diversity, different windows minus traditional",
             "bits",
             less(studies.windows.diversity, studies.traditional.diversity),
             0.5,
             {}}};
}

Comparison diversity_comparison(const std::string& name, const BroadcastStudies& studies) {
    Comparison comparison{.name = name, .against = "known"};
    for (const PlantStudy* study : studies.all()) {
        auto add = [&](const char* column, const std::vector<double>& values) {
            comparison.add(plain_cell(study->islands.name, column, "", median(values), 2));
        };
        add("diversity [bits of 37]", study->diversity);
        add("same best [share]", study->identical);
        comparison.add(plain_cell(study->islands.name, "found [%]", "", study->found_percent(0), 0));
    }
    return comparison;
}

/// Judges the diversity by the diversity over 240 other seeds.
Comparison judged_diversity(const BroadcastStudies& noiseless) {
    Comparison comparison{.name = "number of the 37 bits in which two individuals of an island differ, noiseless",
                          .against = "known"};
    const double known[]{3.8, 5.0, 4.2, 5.3};
    auto all = noiseless.all();
    for (std::size_t i = 0; i < all.size(); ++i)
        comparison.add(
            judged_cell(all[i]->islands.name, "median", "bits", known[i], median(all[i]->diversity), 0.6, 2));
    return comparison;
}

void add_tables(std::vector<Comparison>& comparisons, const BroadcastStudies& studies, double noise) {
    const std::string name = noise_name(noise);
    comparisons.push_back(diversity_comparison("generations 400 to 600, medians, " + name, studies));
    comparisons.push_back(claims_comparison("claims, " + name, claims_of(studies, noise)));
}

Plot two_islands_plot(const BroadcastStudies& noiseless) {
    Plot plot{"Figure 5.4: broadcast in every generation (experiment #2), one run, quartiles of all", {}};
    for (const PlantStudy* study : noiseless.all())
        plot.panels.push_back(
            single_run_panel(study->islands.name, {{"first island", study, 0}, {"last island", study, 3}}));
    return plot;
}

Replay replay_pga_2(const ReplayContext& context) {
    BroadcastStudies noiseless(context, 0), noisy(context, 0.3);
    std::vector<Comparison> comparisons{judged_diversity(noiseless)};
    add_tables(comparisons, noiseless, 0);
    add_tables(comparisons, noisy, 0.3);
    return replay_of(std::move(comparisons), {{"figure-5-4", two_islands_plot(noiseless)}});
}

} // namespace

extern const Experiment pga_2_experiment{
    .name = "pga-2",
    .about = "diversity of islands that broadcast in every generation (Figure 5.4)",
    .chapter = "5",
    .number = 2,
    .run = replay_pga_2,
    .seeds = plant_seeds_of_claims,
};

} // namespace placedpar
