#include "gaprocs/islands.hpp"

#include "gaprocs/usual_settings.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

void require_generations_in_step(std::span<const SearchSettings> islands) {
    for (std::size_t i = 1; i < islands.size(); ++i)
        if (islands[i].window.trials != islands[0].window.trials)
            throw UserError(fmt::format("island 0 makes {} generations per sample and island {} makes {}, expected the "
                                        "same number: they exchange in the same generations",
                                        islands[0].window.trials, i, islands[i].window.trials));
}

/// All that can be wrong whatever the record.
void validate_islands(const IslandsSettings& settings) {
    settings.topology.neighbours(settings.islands.size());
    for (const SearchSettings& island : settings.islands) {
        island.validate();
        settings.emigration.validate_for(island.population);
    }
    require_generations_in_step(settings.islands);
}

/// The settings of each island as they hold for the problem.
IslandsSettings settings_for(const SearchProblem& problem, IslandsSettings settings) {
    for (SearchSettings& island : settings.islands)
        island = placedpar::settings_for(problem, island);
    return settings;
}

void add_estimates(const SearchProblem& problem, const Islands& islands, std::size_t sample, IslandsResult& result) {
    for (std::size_t i = 0; i < result.islands.size(); ++i) {
        const Individual& best = islands.searches()[i].best();
        result.islands[i].estimates.push_back({sample, best, problem.decode(best.genome)});
    }
}

void end_result(const Islands& islands, IslandsResult& result) {
    for (std::size_t i = 0; i < result.islands.size(); ++i) {
        const Search& search = islands.searches()[i];
        result.islands[i].generations = search.generation();
        result.islands[i].redraws = search.redraws();
        result.islands[i].population = search.population();
    }
}

} // namespace

void IslandsSettings::validate_for(std::size_t record_length) const {
    validate_islands(*this);
    for (const SearchSettings& island : islands)
        island.window.validate_for(record_length);
}

Islands::Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams)
    : problem_(problem), settings_(settings_for(problem, std::move(settings))) {
    validate_islands(settings_);
    if (streams.size() != settings_.islands.size())
        throw std::invalid_argument(
            fmt::format("{} streams of random numbers for {} islands", streams.size(), settings_.islands.size()));
    neighbours_ = settings_.topology.neighbours(streams.size());
    fitness_.resize(streams.size());
    for (std::size_t i = 0; i < streams.size(); ++i) {
        windows_.emplace_back(settings_.islands[i].window);
        searches_.emplace_back(problem.representation(), settings_.islands[i], std::move(streams[i]));
    }
}

void Islands::push(const Sample& sample) {
    for (SlidingWindow& window : windows_)
        window.push(sample);
}

bool Islands::ready() const {
    return std::ranges::all_of(windows_, [](const SlidingWindow& window) { return window.ready(); });
}

void Islands::next_generation() {
    evaluate_all();
    migrations_.clear();
    for (std::size_t i = 0; i < searches_.size(); ++i)
        emigrate(i);
    std::ranges::stable_sort(migrations_, {}, &Migration::to);
    auto first = migrations_.begin();
    for (std::size_t i = 0; i < searches_.size(); ++i) {
        auto end = std::find_if(first, migrations_.end(), [&](const Migration& each) { return each.to != i; });
        accept(i, {first, end});
        first = end;
    }
    for (std::size_t i = 0; i < searches_.size(); ++i)
        searches_[i].next_generation(fitness_[i]);
}

void Islands::evaluate_all() {
    for (std::size_t i = 0; i < searches_.size(); ++i)
        fitness_[i] =
            evaluate(problem_, searches_[i].population(), windows_[i].samples(), settings_.islands[i].window.bias);
}

void Islands::emigrate(std::size_t from) {
    std::uint64_t generation = searches_[from].generation() + 1;
    auto destinations = settings_.schedule.destinations(generation, neighbours_[from]);
    if (destinations.empty())
        return;
    auto leaving = searches_[from].emigrants(fitness_[from], settings_.emigration);
    for (std::size_t to : destinations)
        for (const Individual& each : leaving)
            migrations_.push_back({generation, from, to, each, std::nullopt});
}

void Islands::accept(std::size_t island, std::span<Migration> arrivals) {
    if (arrivals.empty())
        return;
    std::vector<Individual> immigrants;
    for (Migration& arrival : arrivals) {
        arrival.individual.fitness = problem_.fitness(arrival.individual.genome, windows_[island].samples(),
                                                      settings_.islands[island].window.bias);
        immigrants.push_back(arrival.individual);
    }
    Places places = searches_[island].accept(immigrants, fitness_[island], settings_.acceptance);
    for (std::size_t i = 0; i < places.size(); ++i)
        arrivals[i].place = places[i];
}

IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& wanted,
                          std::vector<RandomStream> streams) {
    IslandsSettings settings = settings_for(problem, wanted);
    settings.validate_for(record.size());
    Islands islands(problem, settings, std::move(streams));
    IslandsResult result;
    result.islands.resize(settings.islands.size());
    for (std::size_t sample = 0; sample < record.size(); ++sample) {
        islands.push(record[sample]);
        if (!islands.ready())
            continue;
        for (std::size_t trial = 0; trial < settings.islands.front().window.trials; ++trial) {
            islands.next_generation();
            const auto& migrations = islands.migrations();
            result.migrations.insert(result.migrations.end(), migrations.begin(), migrations.end());
        }
        add_estimates(problem, islands, sample, result);
    }
    end_result(islands, result);
    return result;
}

IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams) {
    return run_islands(problem, empty_record(generations), settings, std::move(streams));
}

std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands) {
    std::vector<RandomStream> streams;
    for (std::size_t i = 0; i < islands; ++i)
        streams.emplace_back(seed, fmt::format("island {}", i));
    return streams;
}

} // namespace placedpar
