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

/// The default number of seeds of an experiment. Experiments #1 to #5 take more: with 60 seeds the intervals of some of
/// their claims include the bound.
inline constexpr std::size_t plant_seeds = 60, plant_seeds_of_claims = 240;

/// The best of an island over time, or the answer of a choice.
struct PlantTrack {
    TrackingFigures figures;
    std::vector<Pole> poles; ///< one for every fifth generation
};

/// One configuration with many seeds.
struct PlantStudy {
    PlantIslands islands;
    std::vector<std::vector<PlantTrack>> runs; ///< [seed][island, then choice]
    std::vector<double> diversity, identical;  ///< as in PlantSearchRun, one per seed

    std::vector<double> of(std::size_t track, Tracking) const;
    double median(std::size_t track, Tracking) const;
    /// Returns the lags of the first track.
    std::vector<double> lags() const { return of(0, Tracking::lag); }
    std::vector<double> errors_after() const { return of(0, Tracking::error_after); }
    /// Returns the percentage of runs whose pole is found at the end.
    double found_percent(std::size_t track) const;
    /// Returns the track of a choice.
    std::size_t answer(const std::string& choice) const;
};

/// Runs the configuration with every seed of the replay.
PlantStudy study_plant(const ReplayContext& context, const PlantIslands& islands);

/// Runs a method other than islands with every seed. `follow` returns its pole in each generation. The study has one
/// track.
PlantStudy study_pole(const ReplayContext& context, std::string name, const PlantExperiment& plant,
                      const std::function<std::vector<Pole>(std::uint64_t seed)>& follow);

/// Return, for each seed, the difference or the quotient of the two values. For a given seed, the two values come from
/// the same record.
std::vector<double> less(const std::vector<double>& one, const std::vector<double>& other);
std::vector<double> ratio(const std::vector<double>& one, const std::vector<double>& other);

/// A row in a table of tracks: the study and the index of its track.
struct TrackRow {
    std::string name;
    const PlantStudy* study;
    std::size_t track = 0;
};
/// Returns the row of a choice's answer, with the choice's name.
TrackRow answer_row(const PlantStudy& study, const std::string& choice);
/// Returns the medians over the seeds of each row's figures, without judging them.
Comparison tracks_comparison(std::string name, const std::vector<TrackRow>& rows);

/// Returns the median delay until 20 % of the change is followed, judged by its distance from a known value.
Cell judged_delay(const TrackRow& row, double known, double tolerance);

/// Returns a text such as "medians of 60 seeds, quartiles of the real part".
std::string median_of_seeds(const ReplayContext& context);
/// Plots real part (a line) and imaginary part (dashes) of the pole over generations, as medians over the seeds, with
/// the true pole. With at least two seeds, a band shows the quartiles of the real part.
Panel pole_panel(std::string title, const std::vector<TrackRow>& rows);
/// Plots what pole_panel() plots, except that lines and dashes show only the first run.
Panel single_run_panel(std::string title, const std::vector<TrackRow>& rows);

/// Returns "sigma = 0.3" or "noiseless".
std::string noise_name(double noise);

/// Returns the same configuration with other islands.
PlantIslands sized(PlantIslands islands, std::string name, std::vector<std::size_t> populations,
                   std::vector<std::size_t> windows);
/// Return the configurations of Table 5.3 and those compared with them.
PlantIslands traditional_pga(std::string schedule, double noise);
PlantIslands distributed_pga(std::string schedule, double noise);
/// Returns the configuration with y-hat simulated inside the window, for which five generations a sample and B = 100
/// are best.
PlantIslands simulated_in_window(PlantIslands islands);
/// Return a search with 100 individuals and window 30 (experiment #5), and a search that costs as much as the
/// distributed islands and has a window between theirs.
PlantIslands single_ga(double noise);
PlantIslands equal_cost_ga(double noise);

} // namespace placedpar
