#pragma once

#include "experiments/chapter_5/kit/plant_islands.hpp"
#include "experiments/chapter_5/kit/tracking.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Seeds of an experiment, unless it is told another number. Experiments #1 to #5 take more: with 60 the intervals of
/// some of their claims lie across the bound.
inline constexpr std::size_t plant_seeds = 60, plant_seeds_of_claims = 240;

/// An island's best over time, or a choice's answer.
struct PlantTrack {
    TrackingFigures figures;
    std::vector<Pole> poles; ///< every fifth generation
};

/// One configuration with many seeds.
struct PlantStudy {
    PlantIslands islands;
    std::vector<std::vector<PlantTrack>> runs; ///< [seed][island, then choice]
    std::vector<double> diversity, identical;  ///< as PlantSearchRun, of each seed

    std::vector<double> of(std::size_t track, Tracking) const;
    double median(std::size_t track, Tracking) const;
    /// Of the first track.
    std::vector<double> lags() const { return of(0, Tracking::lag); }
    std::vector<double> errors_after() const { return of(0, Tracking::error_after); }
    /// Share of the runs in percent whose pole is found in the end.
    double found_percent(std::size_t track) const;
    /// The track of a choice.
    std::size_t answer(const std::string& choice) const;
};

/// Every seed of the replay.
PlantStudy study_plant(const ReplayContext& context, const PlantIslands& islands);

/// What something else than islands found in each generation of the record of the seed: a study of one track.
PlantStudy study_pole(const ReplayContext& context, std::string name, const PlantExperiment& plant,
                      const std::function<std::vector<Pole>(std::uint64_t seed)>& follow);

/// Of each seed, the one less the other, or the one by the other. The seeds give both the same record.
std::vector<double> less(const std::vector<double>& one, const std::vector<double>& other);
std::vector<double> ratio(const std::vector<double>& one, const std::vector<double>& other);

/// What the thesis says, as a number: the median over seeds is at least, or at most.
struct Claim {
    std::string text, unit;
    std::vector<double> values;
    std::optional<double> at_least, at_most;

    std::optional<double> bound() const { return at_least ? at_least : at_most; }
};
/// "holds" where the whole interval is on the claimed side, "does not hold" where none of it is.
std::string verdict(const Claim& claim);
/// The medians with their intervals as cells, verdicts in the notes.
Comparison claims_comparison(std::string name, const std::vector<Claim>& claims);

/// A row of a table of tracks: the study and the track in it.
struct TrackRow {
    std::string name;
    const PlantStudy* study;
    std::size_t track = 0;
};
/// The row of a choice's answer, by its name.
TrackRow answer_row(const PlantStudy& study, const std::string& choice);
/// Medians over the seeds of each row's figures; nothing is judged.
Comparison tracks_comparison(std::string name, const std::vector<TrackRow>& rows);

/// The median delay until 20 % of the change is followed, judged by how near it is to a known one.
Cell judged_delay(const TrackRow& row, double known, double tolerance);

/// "medians of 60 seeds, quartiles of the real part"
std::string median_of_seeds(const ReplayContext& context);
/// Real part (a line) and imaginary part (dashes) of the pole over generations, medians of the seeds, beside the truth;
/// a band between the quartiles of the real part, where there are two seeds at least.
Panel pole_panel(std::string title, const std::vector<TrackRow>& rows);
/// The same, but lines and dashes are of one run, the first.
Panel single_run_panel(std::string title, const std::vector<TrackRow>& rows);

/// "sigma = 0.3" or "noiseless".
std::string noise_name(double noise);

/// The same with other islands.
PlantIslands sized(PlantIslands islands, std::string name, std::vector<std::size_t> populations,
                   std::vector<std::size_t> windows);
/// The configurations of Table 5.3, and what they are compared with.
PlantIslands traditional_pga(std::string schedule, double noise);
PlantIslands distributed_pga(std::string schedule, double noise);
/// The other reading of y-hat, under which five generations a sample and B = 100 do best.
PlantIslands simulated_in_window(PlantIslands islands);
/// 100 individuals, window 30 (experiment #5); and as costly as the distributed islands, with a window between theirs.
PlantIslands single_ga(double noise);
PlantIslands equal_cost_ga(double noise);

} // namespace placedpar
