#include "gaprocs/islands.hpp"

#include "gaprocs/search_progress.hpp"
#include "gaprocs/usual_settings.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

void require_generations_in_step(std::span<const SearchSettings> islands) {
    for (std::size_t i = 1; i < islands.size(); ++i)
        if (islands[i].window.trials != islands[0].window.trials)
            throw UserError(fmt::format("island 0 makes {} per sample, but island {} makes {}; expected equal numbers, "
                                        "because islands exchange in the same generations",
                                        counted(islands[0].window.trials, "generation"), i, islands[i].window.trials));
}

void require_places(const IslandsSettings& settings, const Neighbours& neighbours) {
    auto senders = most_senders_at_once(settings.schedule, neighbours);
    for (std::size_t i = 0; i < senders.size(); ++i) {
        const SearchSettings& island = settings.islands[i];
        try {
            Acceptance::validate_for(senders[i] * settings.emigration.count(), island.population, island.elite);
        } catch (const UserError& refused) {
            throw UserError(fmt::format("island {}: {}", i, refused.what()));
        }
    }
}

/// Checks the settings as IslandsSettings::validate_for() does, but does not compare the windows with the length of the
/// record.
void validate_islands(const IslandsSettings& settings) {
    settings.topology.require_numbers_in_range();
    settings.schedule.require_numbers_in_range();
    settings.emigration.require_numbers_in_range();
    settings.acceptance.require_numbers_in_range();
    Neighbours neighbours = settings.topology.neighbours(settings.islands.size());
    for (const SearchSettings& island : settings.islands) {
        island.validate();
        settings.emigration.validate_for(island.population);
    }
    require_generations_in_step(settings.islands);
    require_places(settings, neighbours);
}

/// Returns for each island the islands that make their first generation together with this island, including the island
/// itself.
std::vector<std::vector<std::size_t>> islands_in_step(const Schedule& schedule, const Neighbours& neighbours) {
    std::vector<std::vector<std::size_t>> together(neighbours.size());
    auto parts = separate_parts(schedule.in_step() ? neighbours : Neighbours(neighbours.size()));
    for (const auto& part : parts)
        for (std::size_t island : part)
            together[island] = part;
    return together;
}

/// Returns the settings of each island, adapted to the problem.
IslandsSettings settings_for(const SearchProblem& problem, IslandsSettings settings) {
    for (SearchSettings& island : settings.islands)
        island = placedpar::settings_for(problem, island);
    return settings;
}

void add_estimates(const SearchProblem& problem, const Islands& islands, std::size_t sample, IslandsResult& result) {
    for (std::size_t i = 0; i < result.islands.size(); ++i) {
        if (!islands.has_made(i))
            continue;
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

std::string IslandsSettings::warning() const {
    if (!topology.exchanges())
        return "";
    Neighbours neighbours = topology.neighbours(islands.size());
    auto parts = separate_parts(neighbours);
    if (parts.size() == 1) {
        auto lost = one_way(neighbours);
        return lost ? fmt::format("no individual from island {} ever reaches island {}", lost->from, lost->never_to)
                    : "";
    }
    std::vector<std::string> listed;
    for (const auto& part : parts)
        listed.push_back(fmt::format("{}", fmt::join(part, ", ")));
    return fmt::format("the islands form {} groups that exchange nothing with each other: {}", parts.size(),
                       fmt::join(listed, "; "));
}

Islands::Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams)
    : problem_(problem), settings_(settings_for(problem, std::move(settings))) {
    validate_islands(settings_);
    if (streams.size() != settings_.islands.size())
        throw std::invalid_argument(fmt::format("{} of random numbers for {}, expected one stream for each island",
                                                counted(streams.size(), "stream"),
                                                counted(settings_.islands.size(), "island")));
    neighbours_ = settings_.topology.neighbours(streams.size());
    in_step_ = islands_in_step(settings_.schedule, neighbours_);
    fitness_.resize(streams.size());
    mail_.resize(streams.size());
    made_.resize(streams.size());
    for (std::size_t i = 0; i < streams.size(); ++i) {
        windows_.emplace_back(settings_.islands[i].window);
        searches_.emplace_back(problem.representation(), settings_.islands[i], std::move(streams[i]));
    }
}

void Islands::push(const Sample& sample) {
    for (SlidingWindow& window : windows_)
        window.push(sample);
}

bool Islands::ready(std::size_t island) const {
    return std::ranges::all_of(in_step_[island], [&](std::size_t i) { return windows_[i].ready(); });
}

bool Islands::ready() const {
    for (std::size_t i = 0; i < searches_.size(); ++i)
        if (ready(i))
            return true;
    return false;
}

/// Chooses the islands that make their next generation now: islands that are ready and need not skip this generation.
void Islands::choose_islands() {
    for (std::size_t i = 0; i < searches_.size(); ++i)
        made_[i] = ready(i) && (progress_.empty() || !progress_[i]->passes_over());
}

void Islands::next_generation() {
    migrations_.clear();
    choose_islands();
    if (settings_.schedule.in_step())
        return exchange_in_step();
    for (std::size_t i = 0; i < searches_.size(); ++i)
        if (made_[i]) {
            evaluate_one(i);
            send_by_mail(i);
            auto arrivals = mail_for(i);
            breed(i, arrivals);
            migrations_.insert(migrations_.end(), arrivals.begin(), arrivals.end());
        }
}

void Islands::exchange_in_step() {
    for (std::size_t i = 0; i < searches_.size(); ++i)
        if (made_[i]) {
            evaluate_one(i);
            auto leaving = emigrants(i);
            migrations_.insert(migrations_.end(), leaving.begin(), leaving.end());
        }
    std::ranges::stable_sort(migrations_, {}, &Migration::to);
    std::span<Migration> rest = migrations_;
    for (std::size_t i = 0; i < searches_.size(); ++i) {
        const auto end = std::ranges::find_if(rest, [&](const Migration& each) { return each.to != i; });
        const auto count = static_cast<std::size_t>(end - rest.begin());
        if (made_[i])
            breed(i, rest.first(count));
        rest = rest.subspan(count);
    }
}

void Islands::evaluate_one(std::size_t island) {
    if (!progress_.empty())
        progress_[island]->note_population(searches_[island]);
    fitness_[island] = evaluate(problem_, searches_[island].population(), windows_[island].samples(),
                                settings_.islands[island].window.bias);
}

std::vector<Migration> Islands::emigrants(std::size_t from) {
    std::uint64_t generation = searches_[from].generation() + 1;
    auto destinations = settings_.schedule.destinations(generation, neighbours_[from]);
    if (destinations.empty())
        return {};
    auto leaving = searches_[from].emigrants(fitness_[from], settings_.emigration);
    std::vector<Migration> all;
    for (std::size_t to : destinations)
        for (const Individual& each : leaving)
            all.push_back({generation, from, to, each, std::nullopt});
    return all;
}

/// Sends the island's emigrants to its neighbours. They replace earlier emigrants that a neighbour has not yet
/// received.
void Islands::send_by_mail(std::size_t from) {
    auto leaving = emigrants(from);
    for (const Migration& each : leaving)
        mail_[each.to][from].clear();
    for (const Migration& each : leaving)
        mail_[each.to][from].push_back(each);
}

std::vector<Migration> Islands::mail_for(std::size_t island) {
    std::vector<Migration> arrivals;
    if (!settings_.schedule.is_due(searches_[island].generation() + 1))
        return arrivals;
    for (auto& [from, letters] : mail_[island])
        arrivals.insert(arrivals.end(), letters.begin(), letters.end());
    mail_[island].clear();
    return arrivals;
}

void Islands::breed(std::size_t island, std::span<Migration> arrivals) {
    if (!settings_.acceptance.among_offspring())
        for (Migration& arrival : arrivals)
            arrival.individual.fitness = problem_.fitness(arrival.individual.genome, windows_[island].samples(),
                                                          settings_.islands[island].window.bias);
    accept_and_breed(searches_[island], fitness_[island], arrivals, settings_.acceptance);
    if (observer_)
        tell_migrations(island, arrivals);
    if (progress_.empty())
        return;
    progress_[island]->note_best(searches_[island]);
    progress_[island]->keep(searches_[island]);
}

void Islands::keep_by(Checkpoints& checkpoints) {
    const std::vector<std::string> names = island_names(searches_.size());
    for (std::size_t i = 0; i < searches_.size(); ++i)
        progress_.push_back(std::make_shared<SearchProgress>(searches_[i], names[i], &checkpoints));
}

void Islands::observe_by(SearchObserver& observer) {
    observer_ = &observer;
    names_ = island_names(searches_.size());
    for (std::size_t i = 0; i < searches_.size(); ++i)
        searches_[i].listen(told_to(observer, names_[i], problem_));
}

void Islands::tell_migrations(std::size_t to, std::span<const Migration> arrivals) const {
    for (const Migration& each : arrivals)
        observer_->observe({names_[each.from], names_[to], searches_[to].generation(), std::nullopt,
                            each.individual.fitness, each.place.has_value()});
}

void accept_and_breed(Search& search, std::span<double> fitness, std::span<Migration> arrivals,
                      const Acceptance& acceptance) {
    std::vector<Individual> immigrants;
    for (const Migration& arrival : arrivals)
        immigrants.push_back(arrival.individual);
    Places places;
    if (!arrivals.empty() && !acceptance.among_offspring())
        places = search.accept(immigrants, fitness, acceptance);
    search.next_generation(fitness);
    if (!arrivals.empty() && acceptance.among_offspring())
        places = search.accept_among_offspring(immigrants);
    for (std::size_t i = 0; i < places.size(); ++i)
        arrivals[i].place = places[i];
}

IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& wanted,
                          std::vector<RandomStream> streams, SearchObserver* observer, Checkpoints* checkpoints) {
    IslandsSettings settings = settings_for(problem, wanted);
    settings.validate_for(record.size());
    require_channels(problem, record);
    Islands islands(problem, settings, std::move(streams));
    if (observer)
        islands.observe_by(*observer);
    IslandsResult result;
    result.islands.resize(settings.islands.size());
    if (checkpoints)
        islands.keep_by(*checkpoints);
    for (std::size_t i = 0; i < islands.progress().size(); ++i)
        add_earlier_best(result.islands[i], problem, *islands.progress()[i], islands.searches()[i]);
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
    for (std::size_t i = 0; i < islands.progress().size(); ++i)
        islands.progress()[i]->require_passed(islands.searches()[i]);
    end_result(islands, result);
    return result;
}

IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer, Checkpoints* checkpoints) {
    return run_islands(problem, empty_record(generations), settings, std::move(streams), observer, checkpoints);
}

std::vector<std::string> island_names(std::size_t islands) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < islands; ++i)
        names.push_back(fmt::format("island[{}]", i));
    return names;
}

std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands) {
    std::vector<RandomStream> streams;
    for (const std::string& name : island_names(islands))
        streams.emplace_back(seed, name);
    return streams;
}

} // namespace placedpar
