#include "experiments/chapter_6/kit/plant_runs.hpp"

#include "gaprocs/spread_population.hpp"
#include "gaprocs/traditional.hpp"
#include "problems/plant/plant_problem.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

constexpr PlantExperiment experiment;
constexpr std::size_t before_change = 200, steady_generations = 10;

std::vector<Sample> plant_samples(std::uint64_t seed) { return plant_record(experiment, RandomStream(seed, "plant")); }

Search begin(const PlantSearch& search, std::uint64_t seed) {
    RandomStream random(seed, "search");
    if (!search.spread_start)
        return Search(search.reading.length(), search.settings, std::move(random));
    auto first = spread_population(search.settings.population, search.reading, random);
    return Search(std::move(first), search.settings, std::move(random));
}

/// Calls push(sample) for each sample of the record and next() for each generation, in the order of their times.
template <class Push, class Next>
void for_each_generation(std::uint64_t seed, Push push, Next next) {
    std::vector<Sample> samples = plant_samples(seed);
    auto sample = samples.begin();
    for (std::size_t i = 1; i < experiment.window; ++i)
        push(*sample++);
    for (std::size_t generation = 0; generation < experiment.generations; ++generation) {
        if (generation % experiment.per_sample == 0)
            push(*sample++);
        next();
    }
}

double root_mean_square(const std::vector<double>& values, std::size_t from, std::size_t end) {
    double squares = 0;
    for (std::size_t i = from; i < end; ++i)
        squares += values[i] * values[i];
    return std::sqrt(squares / static_cast<double>(end - from));
}

} // namespace

const SearchProblem& plant_search_problem() {
    static const std::shared_ptr<const SearchProblem> problem = make_search_problem(PlantProblem());
    return *problem;
}

std::vector<std::size_t> plant_field_bits() { return {2, 7, 7, 7, 7, 7}; }

Recoding plant_reading(std::size_t bits, Coding coding) {
    return {.problem_bits = plant_field_bits(), .bits = {2, bits, bits, bits, bits, bits}, .coding = coding};
}

SearchSettings plant_settings(std::size_t population) {
    SearchSettings settings;
    settings.population = population;
    settings.elite = 1;
    settings.reproduction = UniversalReproduction();
    settings.window = {
        .length = experiment.window, .first = experiment.window, .trials = experiment.per_sample, .bias = 10};
    return settings;
}

void PoleTrack::add(const std::vector<double>& parameters) {
    double generation = static_cast<double>(distance_.size());
    Pole pole = pole_of(a1_at(experiment.change, generation), Plant().a2);
    distance_.push_back(std::hypot(parameters[1] - pole.alpha, std::abs(parameters[2]) - pole.beta));
}

PlantOutcome PoleTrack::outcome() const {
    PlantOutcome outcome{{root_mean_square(distance_, 100, 200), root_mean_square(distance_, 200, 400),
                          root_mean_square(distance_, 500, 600)},
                         static_cast<double>(before_change)};
    std::size_t steady = 0;
    for (std::size_t generation = 0; generation < before_change; ++generation) {
        steady = distance_[generation] < PlantOutcome::near_the_pole ? steady + 1 : 0;
        if (steady == steady_generations) {
            outcome.converged_at = static_cast<double>(generation + 1 - steady);
            break;
        }
    }
    return outcome;
}

PlantOutcome run_plant_search(const PlantSearch& search, std::uint64_t seed) {
    const SearchProblem& problem = plant_search_problem();
    Search running = begin(search, seed);
    SlidingWindow window(search.settings.window);
    PoleTrack track;
    for_each_generation(
        seed, [&](const Sample& sample) { window.push(sample); },
        [&] {
            auto read = search.reading.to_problem(running.population());
            running.next_generation(evaluate(problem, read, window.samples(), search.settings.window.bias));
            track.add(problem.decode(search.reading.to_problem(running.best().genome)));
        });
    return track.outcome();
}

PairOutcome run_plant_pair(const CoarseFineSettings& settings, std::uint64_t seed) {
    const SearchProblem& problem = plant_search_problem();
    CoarseFine pair(problem, settings, seed);
    PoleTrack coarse, fine;
    for_each_generation(
        seed, [&](const Sample& sample) { pair.push(sample); },
        [&] {
            pair.next_generation();
            coarse.add(problem.decode(pair.coarse_best().genome));
            fine.add(problem.decode(pair.fine_best().genome));
        });
    return {coarse.outcome(), fine.outcome()};
}

} // namespace placedpar
