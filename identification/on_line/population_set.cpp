#include "identification/on_line/population_set.hpp"

#include "gaprocs/search.hpp"
#include "identification/on_line/window_fitness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

double rms_slope_psi_per_s(const std::vector<SetSample>& window, std::size_t position) {
    double sum = 0;
    for (const SetSample& sample : window)
        sum += sample[position].inlet_slope_psi_per_s * sample[position].inlet_slope_psi_per_s;
    return window.empty() ? 0 : std::sqrt(sum / static_cast<double>(window.size()));
}

PopulationSet::State first_state(LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed,
                                 const std::string& name) {
    RandomStream random(seed, name);
    PopulationSet::State state;
    state.population = random_population(settings.search.population, links.size() * settings.bits, random);
    state.estimates.resize(links.size());
    return state;
}

} // namespace

PopulationSet::PopulationSet(LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed, std::string name)
    : PopulationSet(links, settings, seed, name, first_state(links, settings, seed, name)) {}

PopulationSet::PopulationSet(LinkSet links, const DiagnosisSettings& settings, std::uint64_t seed, std::string name,
                             State state)
    : links_(links), settings_(settings), seed_(seed), name_(std::move(name)), state_(std::move(state)) {}

void PopulationSet::restart_window() {
    state_.window.clear();
    state_.to_skip = 0;
    for (LinkEstimate& estimate : state_.estimates)
        estimate.end_transient();
}

std::size_t PopulationSet::take(const SetProblem& problem, const SetSample& sample, double time_s) {
    ++state_.samples;
    if (!problem.open(sample)) {
        state_.to_skip = settings_.skipped;
        for (LinkEstimate& estimate : state_.estimates)
            estimate.end_transient();
        return 0;
    }
    if (state_.to_skip > 0) {
        --state_.to_skip;
        return 0;
    }
    push(sample);
    const WindowSettings& window = settings_.search.window;
    if (state_.window.size() < std::min(window.first, window.length) ||
        std::ranges::none_of(state_.estimates, &LinkEstimate::excited))
        return 0;
    evolve(problem, time_s);
    return window.trials;
}

void PopulationSet::push(const SetSample& sample) {
    if (state_.window.size() == settings_.search.window.length)
        state_.window.erase(state_.window.begin());
    state_.window.push_back(sample);
    for (std::size_t i = 0; i < state_.estimates.size(); ++i)
        state_.estimates[i].excite(rms_slope_psi_per_s(state_.window, i), settings_);
}

void PopulationSet::evolve(const SetProblem& problem, double time_s) {
    const WindowSettings& window = settings_.search.window;
    const bool frozen = !std::ranges::all_of(state_.estimates, &LinkEstimate::excited);
    std::vector<Genome> former = frozen ? state_.population : std::vector<Genome>();
    Search search(std::move(state_.population), settings_.search,
                  RandomStream(seed_, fmt::format("{}/{}", name_, state_.samples)));
    WindowFitness fitness(problem, state_.window, window.bias);
    for (std::size_t trial = 0; trial < window.trials; ++trial) {
        search.next_generation(fitness(search.population()));
        ++state_.generations;
        record(problem, search.best(), time_s);
    }
    state_.population = std::move(search).take_population();
    if (frozen)
        keep_frozen_columns(former);
    add_errors(problem);
}

void PopulationSet::add_errors(const SetProblem& problem) {
    std::vector<double> answer(state_.estimates.size());
    for (std::size_t i = 0; i < answer.size(); ++i)
        answer[i] = state_.estimates[i].compliance_in3_per_psi().value_or(0);
    const std::vector<double> errors = problem.standard_errors_in3_per_psi(state_.window, answer);
    for (std::size_t i = 0; i < answer.size(); ++i)
        if (state_.estimates[i].excited())
            state_.estimates[i].add_error(errors[i]);
}

void PopulationSet::record(const SetProblem& problem, const Individual& best, double time_s) {
    for (std::size_t i = 0; i < state_.estimates.size(); ++i) {
        LinkEstimate& estimate = state_.estimates[i];
        if (!estimate.excited())
            continue;
        if (best.fitness > 0)
            estimate.add(problem.compliance_in3_per_psi(best.genome, i), time_s, problem.step_in3_per_psi(), settings_);
        else
            estimate.nothing_fits();
    }
}

void PopulationSet::keep_frozen_columns(const std::vector<Genome>& former) {
    for (std::size_t i = 0; i < state_.estimates.size(); ++i) {
        if (state_.estimates[i].excited())
            continue;
        std::size_t first = i * settings_.bits, count = settings_.bits;
        for (std::size_t j = 0; j < former.size(); ++j)
            state_.population[j].set_field(first, count, former[j].field(first, count));
    }
}

} // namespace placedpar::identification
