#include "experiments/chapter_5/kit/plant_study.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "identification/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <future>
#include <iterator>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>

namespace placedpar {

namespace {

struct StudiedRun {
    std::vector<PlantTrack> tracks;
    double diversity, identical;
};

constexpr std::size_t plotted_every = 5;

PlantTrack track_of(const std::vector<Pole>& found, PlantChange change) {
    PlantTrack result{track(found, change), {}};
    for (std::size_t generation = 0; generation < found.size(); generation += plotted_every)
        result.poles.push_back(found[generation]);
    return result;
}

void add_tracks(StudiedRun& run, const std::vector<std::vector<Pole>>& found, PlantChange change) {
    for (const auto& each : found)
        run.tracks.push_back(track_of(each, change));
}

StudiedRun studied_run(const PlantIslands& islands, std::uint64_t seed) {
    PlantSearchRun run = search_plant(islands, seed);
    StudiedRun result{{}, run.diversity, run.identical};
    add_tracks(result, run.islands, islands.plant.change);
    add_tracks(result, run.answers, islands.plant.change);
    return result;
}

template <class Combine>
std::vector<double> paired(const std::vector<double>& one, const std::vector<double>& other, Combine combine) {
    std::vector<double> values;
    std::ranges::transform(one, other, std::back_inserter(values), combine);
    return values;
}

void add_run(PlantStudy& study, StudiedRun run) {
    study.runs.push_back(std::move(run.tracks));
    study.diversity.push_back(run.diversity);
    study.identical.push_back(run.identical);
}

/// A thread for each.
void add_runs(PlantStudy& study, std::span<const std::uint64_t> seeds) {
    std::vector<std::future<StudiedRun>> under_way;
    for (std::uint64_t seed : seeds)
        under_way.push_back(std::async(std::launch::async, studied_run, std::cref(study.islands), seed));
    for (std::future<StudiedRun>& run : under_way)
        add_run(study, run.get());
}

} // namespace

std::vector<double> PlantStudy::of(std::size_t track, Tracking figure) const {
    std::vector<double> values;
    for (const auto& run : runs)
        values.push_back(run[track].figures[static_cast<std::size_t>(figure)]);
    return values;
}

double PlantStudy::median(std::size_t track, Tracking figure) const {
    return identification::median(of(track, figure));
}

double PlantStudy::found_percent(std::size_t track) const {
    return percent_within(of(track, Tracking::error_after), found_pole);
}

std::size_t PlantStudy::answer(const std::string& choice) const {
    auto found = std::ranges::find(islands.choices, choice);
    if (found == islands.choices.end())
        throw std::invalid_argument(fmt::format("{} has no answer by {}", islands.name, choice));
    return islands.windows.size() + static_cast<std::size_t>(found - islands.choices.begin());
}

PlantStudy study_plant(const ReplayContext& context, const PlantIslands& islands, const Seeds& seeds) {
    PlantStudy study{islands, {}, {}, {}};
    const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t first = 0; first < seeds.size(); first += at_once) {
        end_if_requested(context.interruption);
        context.progress(
            fmt::format("{}, {}: {} of {} seeds", islands.name, noise_name(islands.plant.noise), first, seeds.size()));
        add_runs(study, std::span(seeds).subspan(first, std::min(at_once, seeds.size() - first)));
    }
    return study;
}

std::vector<double> less(const std::vector<double>& one, const std::vector<double>& other) {
    return paired(one, other, std::minus<>());
}

std::vector<double> ratio(const std::vector<double>& one, const std::vector<double>& other) {
    // A deviation of 0 happens: the elite stays. A thousandth is far below the resolution of the strings.
    constexpr double nothing = 0.001;
    return paired(one, other, [](double a, double b) { return (a + nothing) / (b + nothing); });
}

std::string noise_name(double noise) { return noise == 0 ? "noiseless" : fmt::format("sigma = {}", noise); }

PlantIslands sized(PlantIslands islands, std::string name, std::vector<std::size_t> populations,
                   std::vector<std::size_t> windows) {
    islands.name = std::move(name);
    islands.populations = std::move(populations);
    islands.windows = std::move(windows);
    return islands;
}

PlantIslands traditional_pga(std::string schedule, double noise) {
    PlantIslands islands = sized({}, "traditional", equal_populations, equal_windows);
    islands.topology = schedule.starts_with("sequential") ? "hypercube" : "complete";
    islands.schedule = std::move(schedule);
    islands.plant.noise = noise;
    return islands;
}

PlantIslands distributed_pga(std::string schedule, double noise) {
    return sized(traditional_pga(std::move(schedule), noise), "distributed", distributed_populations,
                 distributed_windows);
}

PlantIslands single_ga(double noise) {
    PlantIslands islands = sized({}, "GA of 100, window 30", {100}, {30});
    islands.plant.noise = noise;
    return islands;
}

PlantIslands equal_cost_ga(double noise) {
    // 24 * 30 + 30 * 24 + 40 * 16 + 50 * 10 = 2580 errors a generation = 129 * 20.
    return sized(single_ga(noise), "GA of equal cost, window 20", {129}, {20});
}

} // namespace placedpar
