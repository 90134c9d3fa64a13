#include "experiments/chapter_5/kit/plant_study.hpp"

#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t plotted_every = 5;

// The figures of a run are `diversity` and `identical`. Then, for each track, its TrackingFigures and every fifth pole
// follow.

void append_track(Figures& figures, const std::vector<Pole>& found, const PlantChange& change) {
    TrackingFigures tracking = track(found, change);
    figures.insert(figures.end(), tracking.begin(), tracking.end());
    for (std::size_t generation = 0; generation < found.size(); generation += plotted_every)
        figures.insert(figures.end(), {found[generation].alpha, found[generation].beta});
}

Figures figures_of(const PlantIslands& islands, std::uint64_t seed) {
    PlantSearchRun run = search_plant(islands, seed);
    Figures figures{run.diversity, run.identical};
    for (const auto* tracks : {&run.islands, &run.answers})
        for (const auto& found : *tracks)
            append_track(figures, found, islands.plant.change);
    return figures;
}

PlantTrack read_track(std::span<const double> figures) {
    PlantTrack track{};
    std::ranges::copy(figures.first(tracking_figures), track.figures.begin());
    for (std::size_t i = tracking_figures; i < figures.size(); i += 2)
        track.poles.push_back({figures[i], figures[i + 1]});
    return track;
}

void add_run(PlantStudy& study, std::span<const double> figures) {
    study.diversity.push_back(figures[0]);
    study.identical.push_back(figures[1]);
    std::size_t tracks = study.islands.windows.size() + study.islands.choices.size();
    auto of_tracks = figures.subspan(2);
    std::size_t length = of_tracks.size() / tracks;
    study.runs.emplace_back();
    for (std::size_t i = 0; i < tracks; ++i)
        study.runs.back().push_back(read_track(of_tracks.subspan(i * length, length)));
}

std::string name_of(const PlantIslands& islands) {
    std::string name = fmt::format("{}, {}", islands.name, noise_name(islands.plant.noise));
    if (auto [c1, c2] = islands.plant.colour; c1 != 0 || c2 != 0)
        name += fmt::format(", c1 = {}, c2 = {}", c1, c2);
    return islands.choices.empty() ? name : fmt::format("{}, answers by {}", name, fmt::join(islands.choices, ", "));
}

template <class Combine>
std::vector<double> paired(const std::vector<double>& one, const std::vector<double>& other, Combine combine) {
    std::vector<double> values;
    std::ranges::transform(one, other, std::back_inserter(values), combine);
    return values;
}

} // namespace

std::vector<double> PlantStudy::of(std::size_t track, Tracking figure) const {
    std::vector<double> values;
    for (const auto& run : runs)
        values.push_back(run[track].figures[static_cast<std::size_t>(figure)]);
    return values;
}

double PlantStudy::median(std::size_t track, Tracking figure) const { return placedpar::median(of(track, figure)); }

double PlantStudy::found_percent(std::size_t track) const {
    return percent_within(of(track, Tracking::error_after), found_pole);
}

std::size_t PlantStudy::answer(const std::string& choice) const {
    auto found = std::ranges::find(islands.choices, choice);
    if (found == islands.choices.end())
        throw std::invalid_argument(fmt::format("{} has no answer by {}", islands.name, choice));
    return islands.windows.size() + static_cast<std::size_t>(found - islands.choices.begin());
}

PlantStudy study_plant(const ReplayContext& context, const PlantIslands& islands) {
    PlantStudy study{islands, {}, {}, {}};
    for (const Figures& run :
         run_seeds(context, name_of(islands), [&](std::uint64_t seed) { return figures_of(islands, seed); }))
        add_run(study, run);
    return study;
}

PlantStudy study_pole(const ReplayContext& context, std::string name, const PlantExperiment& plant,
                      const std::function<std::vector<Pole>(std::uint64_t seed)>& follow) {
    PlantIslands one;
    one.name = std::move(name);
    one.plant = plant;
    PlantStudy study{one, {}, {}, {}};
    for (const Figures& run : run_seeds(context, name_of(study.islands), [&](std::uint64_t seed) {
             Figures figures{0, 0};
             append_track(figures, follow(seed), plant.change);
             return figures;
         }))
        add_run(study, run);
    return study;
}

std::vector<double> less(const std::vector<double>& one, const std::vector<double>& other) {
    return paired(one, other, std::minus<>());
}

std::vector<double> ratio(const std::vector<double>& one, const std::vector<double>& other) {
    // A deviation may be 0, since the elite may stay unchanged. A thousandth is far below the resolution of the
    // strings.
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

PlantIslands simulated_in_window(PlantIslands islands) {
    islands.name += ", simulated";
    islands.simulated = true;
    islands.bias = 100;
    islands.plant.per_sample = 5;
    return islands;
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
