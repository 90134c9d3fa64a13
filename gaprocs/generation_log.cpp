#include "gaprocs/generation_log.hpp"

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/objective.hpp"
#include "gaprocs/policies/individual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

/// Returns the objective's value for a fitness: the fitness itself, or its negative if the objective is minimised. If
/// the objective was not a finite number, returns the infinity that is worst for the goal. If the problem has no
/// objective, returns the fitness.
double in_its_own_sign(double fitness, std::optional<Goal> goal) {
    if (goal && fitness <= worst_fitness)
        fitness = -std::numeric_limits<double>::infinity();
    return goal == Goal::minimise ? 0 - fitness : fitness;
}

std::size_t count_finite(std::span<const double> fitness) {
    return static_cast<std::size_t>(std::ranges::count_if(fitness, [](double each) { return each > worst_fitness; }));
}

/// Returns the mean of the finite values, or worst_fitness if none is finite.
double mean_of(std::span<const double> fitness) {
    double sum = 0;
    for (double each : fitness)
        sum += each <= worst_fitness ? 0 : each;
    std::size_t finite = count_finite(fitness);
    return finite == 0 ? worst_fitness : sum / static_cast<double>(finite);
}

void add_rows(std::vector<LogRow>& rows, std::uint64_t generation, std::string_view search,
              const LoggedGeneration& found) {
    auto add = [&](std::string_view quantity, double value) {
        rows.push_back({generation, found.time, search, "", quantity, value});
    };
    add("best_so_far", found.best_so_far);
    add("best", found.best);
    add("mean", found.mean);
    add("diversity", found.diversity);
}

void add_rows_of_all(std::vector<LogRow>& rows, std::uint64_t generation, const LoggedGeneration& found) {
    add_rows(rows, generation, "all", found);
    rows.push_back({generation, found.time, "all", "", "diversity_between", found.between});
    rows.push_back({generation, found.time, "all", "", "fixation", fixation(found.diversity, found.between)});
}

} // namespace

GenerationLog::GenerationLog(std::vector<std::string> searches, bool comparable)
    : searches_(std::move(searches)), compared_(comparable && searches_.size() > 1), goals_(searches_.size()),
      earlier_(searches_.size()), generations_(searches_.size()) {}

void GenerationLog::continue_from(const Checkpoints& checkpoints) {
    for (std::size_t i = 0; i < searches_.size(); ++i)
        if (const SearchCheckpoint* begin = checkpoints.begin_of(searches_[i]))
            earlier_[i] = begin->improvements;
}

std::size_t GenerationLog::number_of(std::string_view search) const {
    auto found = std::ranges::find(searches_, search);
    if (found == searches_.end())
        throw std::invalid_argument(fmt::format("the log has no search \"{}\"", search));
    return static_cast<std::size_t>(found - searches_.begin());
}

void GenerationLog::observe(const ObservedGeneration& generation) {
    std::size_t search = number_of(generation.search);
    goals_[search] = generation.goal;
    if (generations_[search].empty())
        first_ = generation.number;
    Spread spread = spread_of(generation.population, generation.representation);
    LoggedGeneration found = found_in(generation, search, spread);
    generations_[search].push_back(found);
    if (compared_)
        wait_for_the_others(generation.number, search, {found, count_finite(generation.fitness), std::move(spread)});
}

double GenerationLog::better(std::size_t search, double a, double b) const {
    return minimises(search) ? std::min(a, b) : std::max(a, b);
}

LoggedGeneration GenerationLog::found_in(const ObservedGeneration& generation, std::size_t search,
                                         const Spread& spread) const {
    const auto& before = generations_[search];
    double best = in_its_own_sign(generation.fitness[best_index(generation.fitness)], generation.goal);
    double best_so_far = best;
    if (!before.empty())
        best_so_far = better(search, before.back().best_so_far, best);
    else if (!earlier_[search].empty())
        best_so_far = better(search, in_its_own_sign(earlier_[search].back().fitness, generation.goal), best);
    return {generation.time, best_so_far, best, in_its_own_sign(mean_of(generation.fitness), generation.goal),
            diversity_within(spread)};
}

std::vector<LoggedStep> GenerationLog::steps_of(std::size_t search) const {
    std::vector<LoggedStep> steps;
    for (const Improvement& each : earlier_.at(search))
        steps.push_back({each.generation, in_its_own_sign(each.fitness, goals_[search])});
    for (std::size_t i = 0; i < generations_.at(search).size(); ++i)
        if (const double value = generations_[search][i].best_so_far; steps.empty() || value != steps.back().value)
            steps.push_back({first_ + i, value});
    return steps;
}

std::vector<LoggedStep> GenerationLog::steps_of_all() const {
    std::map<std::uint64_t, double> best; // key: a generation; value: the best fitness of the searches that log it
    for (std::size_t search = 0; search < searches_.size(); ++search)
        for (const auto& [generation, value] : steps_of(search))
            if (const auto [known, is_new] = best.emplace(generation, value); !is_new)
                known->second = better(0, known->second, value);
    std::vector<LoggedStep> steps;
    for (const auto& [generation, value] : best)
        if (generation < first_ + all_.size() &&
            (steps.empty() || better(0, steps.back().value, value) != steps.back().value))
            steps.push_back({generation, value});
    return steps;
}

void GenerationLog::observe(const ObservedMigration& migration) {
    migrations_.push_back({migration.generation, number_of(migration.from), number_of(migration.to), migration.time,
                           migration.fitness, migration.accepted});
}

void GenerationLog::observe(const ObservedAnswer& answer) {
    answers_.push_back({answer.generation,
                        std::string(answer.analyst),
                        number_of(answer.chosen),
                        answer.time,
                        {answer.names.begin(), answer.names.end()},
                        {answer.values.begin(), answer.values.end()}});
}

void GenerationLog::wait_for_the_others(std::uint64_t generation, std::size_t search, Evaluated&& evaluated) {
    Row& row = waiting_[generation];
    row.resize(searches_.size());
    row[search] = std::move(evaluated);
    if (std::ranges::all_of(row, [](const auto& each) { return each.has_value(); })) {
        add_to_all(row);
        waiting_.erase(generation);
    }
}

void GenerationLog::add_to_all(const Row& row) {
    LoggedGeneration all = row.front()->found;
    std::vector<Spread> spreads;
    double sum = 0, finite = 0, diversity = 0;
    for (const auto& each : row) {
        all.time = std::max(all.time, each->found.time);
        all.best = better(0, all.best, each->found.best);
        all.best_so_far = better(0, all.best_so_far, each->found.best_so_far);
        sum += each->finite == 0 ? 0 : each->found.mean * static_cast<double>(each->finite);
        finite += static_cast<double>(each->finite);
        diversity += each->found.diversity;
        spreads.push_back(each->spread);
    }
    all.mean = finite == 0 ? row.front()->found.mean : sum / finite;
    all.diversity = diversity / static_cast<double>(row.size());
    all.between = diversity_between(spreads);
    all_.push_back(all);
}

std::vector<LogRow> GenerationLog::rows_of_migrations() const {
    std::vector<LoggedMigration> sorted = migrations_;
    std::ranges::stable_sort(sorted, {}, [](const auto& each) { return std::pair(each.generation, each.to); });
    std::vector<LogRow> rows;
    for (const LoggedMigration& each : sorted)
        rows.push_back({each.generation, each.time, searches_[each.to], searches_[each.from],
                        each.accepted ? "accepted" : "turned_away", in_its_own_sign(each.fitness, goals_[each.to])});
    return rows;
}

std::vector<LogRow> GenerationLog::rows_of_answers() const {
    std::vector<LogRow> rows;
    for (const LoggedAnswer& each : answers_)
        for (std::size_t i = 0; i < each.values.size(); ++i)
            rows.push_back(
                {each.generation, each.time, each.analyst, searches_[each.chosen], each.names[i], each.values[i]});
    std::ranges::stable_sort(rows, {}, [](const LogRow& row) { return std::pair(row.generation, row.search); });
    return rows;
}

std::vector<LogRow> GenerationLog::rows() const {
    std::vector<LogRow> rows, migrations = rows_of_migrations(), answers = rows_of_answers();
    auto migration = migrations.begin(), answer = answers.begin();
    auto came_to = [&](std::string_view search, std::uint64_t generation) {
        return migration != migrations.end() && migration->search == search && migration->generation == generation;
    };
    std::size_t last = 0;
    for (const auto& each : generations_)
        last = std::max(last, each.size());
    for (std::size_t g = 0; g < last; ++g) {
        const std::uint64_t number = first_ + g;
        for (std::size_t i = 0; i < searches_.size(); ++i) {
            while (came_to(searches_[i], number))
                rows.push_back(*migration++);
            if (g < generations_[i].size())
                add_rows(rows, number, searches_[i], generations_[i][g]);
        }
        if (g < all_.size())
            add_rows_of_all(rows, number, all_[g]);
        for (; answer != answers.end() && answer->generation == number; ++answer)
            rows.push_back(*answer);
    }
    rows.insert(rows.end(), migration, migrations.end()); // migrations of a generation that no search has logged
    return rows;
}

} // namespace placedpar
