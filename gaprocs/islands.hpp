#pragma once

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_observer.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The settings of several islands. By default they form a ring: after every third generation the best individual of
/// each island replaces the worst of the next island.
struct IslandsSettings {
    /// Settings of each island. Populations, rates and windows may differ; the number of generations per sample must be
    /// equal.
    std::vector<SearchSettings> islands;
    Topology topology;
    Schedule schedule;
    Emigration emigration;
    Acceptance acceptance;

    /// Throws UserError as SearchSettings and as Topology::neighbours() do. Throws it also if an island has fewer
    /// individuals than emigrants, or can accept fewer immigrants than come at once. Throws it also if islands have
    /// different numbers of generations per sample.
    void validate_for(std::size_t record_length) const;
    /// Returns a warning about a topology that is allowed but probably unintended: some parts do not exchange with each
    /// other, or the individuals of some island never reach another. Returns "" if there is no warning. Throws as
    /// Topology::neighbours().
    std::string warning() const;
};

/// An individual that moves from one island to another.
struct Migration {
    std::uint64_t generation; ///< generation after which it leaves; generations count from 1
    std::size_t from, to;
    /// The individual. Its fitness belongs to the window of its new island. With OffspringAcceptance, which evaluates
    /// it only in the next generation, the fitness still belongs to the old window.
    Individual individual;
    std::optional<std::size_t> place; ///< index of the individual that it replaces; nothing if it is rejected

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// Accepts the immigrants in the given order, sets their places, and breeds the next generation. Throws as
/// Search::accept() and next_generation(). REQUIRES: each immigrant's fitness belongs to this island's window, unless
/// immigrants come among the offspring.
void accept_and_breed(Search&, std::span<double> fitness, std::span<Migration> arrivals, const Acceptance&);

/// Several searches over the same record, which make their generations in step. In each generation all islands are
/// evaluated, emigrants leave, each island accepts its immigrants, and all islands breed. An island accepts immigrants
/// in the order of their islands' numbers. The order in which the islands are computed has no influence: each island
/// draws from its own random stream, and all emigrants are chosen before the first immigrant is accepted. Islands of
/// one connected part begin together, when all of them have enough samples.
///
/// An immigrant is evaluated again in the window of its new island. If both islands have the same window, its fitness
/// does not change, because it is exact (gaprocs/fitness.hpp). Immigrants among the offspring are evaluated one
/// generation later.
///
/// With the asynchronous schedule no island waits for another. Here there is no machine with times, so the islands take
/// turns: in each generation island 0 evaluates, sends, accepts the immigrants that have arrived so far, and breeds;
/// then island 1 does, and so on.
class Islands {
public:
    /// `streams`: one random stream for each island, from which its first population is drawn. REQUIRES: `problem`
    /// outlives the islands. Throws as settings_for(), and as IslandsSettings::validate_for() for a record of any
    /// length. Throws std::invalid_argument if the number of streams differs from the number of islands.
    Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams);

    /// Reports every generation from now on to the observer, with the names of island_names(). REQUIRES: the observer
    /// outlives the islands.
    void observe_by(SearchObserver& observer);

    /// Adds a new sample to the window of every island.
    void push(const Sample& sample);
    /// Returns whether this island, and all islands that are in step with it, have enough samples for a generation.
    bool ready(std::size_t island) const;
    /// Returns whether any island is ready.
    bool ready() const;
    /// Makes one generation of each island that is ready.
    void next_generation();

    const std::vector<Search>& searches() const { return searches_; }
    /// Returns the migrations of the last next_generation(), sorted by destination and then in the order of acceptance;
    /// empty if no exchange was due.
    const std::vector<Migration>& migrations() const { return migrations_; }

private:
    void exchange_in_step();
    void evaluate_one(std::size_t island);
    std::vector<Migration> emigrants(std::size_t from);
    void send_by_mail(std::size_t from);
    std::vector<Migration> mail_for(std::size_t island);
    void breed(std::size_t island, std::span<Migration> arrivals);
    void tell_migrations(std::size_t to, std::span<const Migration> arrivals) const;

    const SearchProblem& problem_;
    IslandsSettings settings_;
    Neighbours neighbours_;
    std::vector<std::vector<std::size_t>>
        in_step_; ///< for each island, the islands that begin together with it, including itself
    std::vector<SlidingWindow> windows_;
    std::vector<Search> searches_;
    std::vector<std::vector<double>> fitness_; ///< fitness in this generation, by island and individual
    std::vector<Migration> migrations_;
    /// In the asynchronous schedule: migrations that have not been accepted yet, by destination and source.
    std::vector<std::map<std::size_t, std::vector<Migration>>> mail_;
    SearchObserver* observer_ = nullptr;
    std::vector<std::string> names_; ///< names of the islands for the observer
};

struct IslandsResult {
    std::vector<SearchResult> islands;
    std::vector<Migration> migrations; ///< migrations of all generations, in the order of generations
};

/// Runs the islands over a record, without processes, a machine or times. Throws as Islands and
/// IslandsSettings::validate_for().
IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr);
/// Runs the islands on an objective, without a record. Each island gives one estimate for each generation.
IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr);

/// Returns "island[0]", "island[1]", ..., the names of processes that a netlist declares as island[n].
std::vector<std::string> island_names(std::size_t islands);
/// Returns the random streams of a run. Their names are those of island_names().
std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands);

} // namespace placedpar
