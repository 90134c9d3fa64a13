#pragma once

#include "experiments/chapter_5/kit/plant_islands.hpp"
#include "experiments/chapter_5/kit/tracking.hpp"
#include "experiments/kit/claims.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// The default number of seeds of an experiment. Experiments #1 to #5 have more seeds, because with 60 seeds the
/// intervals of some claims include the bound.
inline constexpr std::size_t plant_seeds = 60, plant_seeds_of_claims = 240;

/// How one run follows the pole of the changing plant: by the best individuals of an island, or by the answers of a
/// rule that chooses an island.
struct PlantTrack {
    TrackingFigures figures;
    std::vector<Pole> poles; ///< one for every fifth generation
};

struct PlantStudy {
    PlantIslands islands;
    std::vector<std::vector<PlantTrack>> runs; ///< [seed][track]; the tracks are the islands, then the choices
    std::vector<double> diversity, identical;  ///< as in PlantSearchRun, one for each seed

    std::vector<double> of(std::size_t track, Tracking) const;
    double median(std::size_t track, Tracking) const;
    /// Returns the lags of the first track.
    std::vector<double> lags() const { return of(0, Tracking::lag); }
    std::vector<double> errors_after() const { return of(0, Tracking::error_after); }
    /// Returns the percentage of runs with `error_after` of at most `found_pole`.
    double found_percent(std::size_t track) const;
    /// Returns the index of the track of a rule.
    std::size_t answer(const std::string& choice) const;
};

/// Runs the configuration with every seed of the replay.
PlantStudy study_plant(const ReplayContext& context, const PlantIslands& islands);

/// Runs a method without islands with every seed. `follow` returns the pole that the method found in each generation.
/// The study has one track.
PlantStudy study_pole(const ReplayContext& context, std::string name, const PlantExperiment& plant,
                      const std::function<std::vector<Pole>(std::uint64_t seed)>& follow);

/// These functions return, for each seed, the difference or the quotient of two values from the same record. For a
/// quotient, .001 is added to both values, because values may be 0.
std::vector<double> less(const std::vector<double>& one, const std::vector<double>& other);
std::vector<double> ratio(const std::vector<double>& one, const std::vector<double>& other);

struct TrackRow {
    std::string name;
    const PlantStudy* study;
    std::size_t track = 0;
};
/// Returns a row for the answers of a rule that chooses an island. The row has the name of the rule.
TrackRow answer_row(const PlantStudy& study, const std::string& choice);
/// Returns a row for the first track of each study. The row has the name of the study's islands.
std::vector<TrackRow> study_rows(const std::vector<PlantStudy>& studies);
/// Returns a table of the medians of each row's figures over the seeds. The table is not judged.
Comparison tracks_comparison(std::string name, const std::vector<TrackRow>& rows);

/// Returns a cell with the median of `delay_20`, judged by its distance from the known value.
Cell judged_delay(const TrackRow& row, double known, double tolerance);

/// Returns a text such as "medians of 60 seeds, quartiles of the real part".
std::string median_of_seeds(const ReplayContext& context);
/// Plots the real part (lines) and the imaginary part (dashes) of the found pole and of the true pole over the
/// generations. The found pole is shown by its median over the seeds. With at least two seeds, a band shows the
/// quartiles of the real part.
Panel pole_panel(std::string title, const std::vector<TrackRow>& rows);
/// Plots the same as pole_panel(), but with the found pole of the first run instead of the median.
Panel single_run_panel(std::string title, const std::vector<TrackRow>& rows);

/// Returns "sigma = 0.3" or "noiseless".
std::string noise_name(double noise);

/// Returns the configuration with this name, these populations and these windows.
PlantIslands sized(PlantIslands islands, std::string name, std::vector<std::size_t> populations,
                   std::vector<std::size_t> windows);
/// These functions return the configurations of Table 5.3.
PlantIslands traditional_pga(std::string schedule, double noise);
PlantIslands distributed_pga(std::string schedule, double noise);
/// Returns the configuration with y-hat simulated inside the window, five generations for each sample, and B = 100.
/// These values work best with the simulated y-hat.
PlantIslands simulated_in_window(PlantIslands islands);
/// These functions return single searches. single_ga() has 100 individuals and a window of 30 samples (experiment #5).
/// equal_cost_ga() has a window of 20 samples, and computes as much as the distributed islands together.
PlantIslands single_ga(double noise);
PlantIslands equal_cost_ga(double noise);

} // namespace placedpar
