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

/// Islands that search side by side; by default a ring in which every third generation the best of each replaces the
/// worst of the next.
struct IslandsSettings {
    /// Settings of each island: populations, rates and windows may differ, generations per sample may not.
    std::vector<SearchSettings> islands;
    Topology topology;
    Schedule schedule;
    Emigration emigration;
    Acceptance acceptance;

    /// Throws UserError as the islands' settings for this record, and as Topology::neighbours(); also for more
    /// emigrants than an island has individuals, more immigrants at once than it can accept, and islands with different
    /// numbers of generations per sample.
    void validate_for(std::size_t record_length) const;
    /// Returns a warning about a topology that is allowed but probably unintended: it has parts that exchange nothing
    /// with each other, or the individuals of some island never reach another. Returns "" if there is nothing to warn
    /// of. Throws as Topology::neighbours().
    std::string warning() const;
};

/// An individual that moves from one island to another.
struct Migration {
    std::uint64_t generation; ///< generation after whose evaluation it left, from 1
    std::size_t from, to;
    /// The individual with its fitness in the window of its new island; with OffspringAcceptance, which evaluates it
    /// only in the next generation, with its fitness in its old window.
    Individual individual;
    std::optional<std::size_t> place; ///< index of the individual that it replaces; nothing if it is turned away

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// Accepts the immigrants in their order, sets their places, and breeds the next generation. Unless immigrants come
/// among the offspring, their fitness must be that in this island's window. Throws as Search::accept() and
/// next_generation().
void accept_and_breed(Search&, std::span<double> fitness, std::span<Migration> arrivals, const Acceptance&);

/// Several searches over the same record, generation by generation in step: all are evaluated; emigrants leave; each
/// island accepts its immigrants, those of the island of lowest number first; all breed. Nothing depends on an order in
/// which islands take their turns: each draws from a stream of its own, and all emigrants are chosen before the first
/// immigrant is accepted. Islands of one connected part begin together, when all have enough samples.
///
/// An immigrant's fitness is found anew in the window of its new island. If both islands have the same window, the
/// fitness does not change: it is exact (gaprocs/fitness.hpp). Immigrants among the offspring are evaluated one
/// generation later.
///
/// With the asynchronous schedule no island waits: without a machine and its times, islands take turns, and in each
/// generation island 0 evaluates, sends, accepts the immigrants that have arrived so far and breeds, then island 1, and
/// so on.
class Islands {
public:
    /// `streams`: one for each island, from which its first population is drawn. `problem` must outlive this. Throws as
    /// IslandsSettings::validate_for() for a record of any length and settings_for(), and std::invalid_argument for
    /// another number of streams.
    Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams);

    /// Tells the observer of every generation from now on, with the islands named as by island_names(). REQUIRES: the
    /// observer outlives this.
    void observe_by(SearchObserver& observer);

    /// Adds a new sample to the window of every island.
    void push(const Sample& sample);
    /// Returns whether there are enough samples for a generation of this island, and of all islands that are in step
    /// with it.
    bool ready(std::size_t island) const;
    /// Returns whether any island is ready.
    bool ready() const;
    /// Makes one generation of the islands that are ready.
    void next_generation();

    const std::vector<Search>& searches() const { return searches_; }
    /// Returns the migrations of the last next_generation(), by destination and then in the order in which they were
    /// accepted; empty if no exchange was due.
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
        in_step_; ///< for each island, the islands with which it begins, including itself
    std::vector<SlidingWindow> windows_;
    std::vector<Search> searches_;
    std::vector<std::vector<double>> fitness_; ///< fitness in this generation, by island and individual
    std::vector<Migration> migrations_;
    /// Asynchronous: migrations that have not been accepted yet, by destination and origin.
    std::vector<std::map<std::size_t, std::vector<Migration>>> mail_;
    SearchObserver* observer_ = nullptr;
    std::vector<std::string> names_; ///< by which the observer knows the islands
};

struct IslandsResult {
    std::vector<SearchResult> islands;
    std::vector<Migration> migrations; ///< migrations of all generations, in order
};

/// Runs the islands over a record, without processes, machine or time. Throws as Islands and
/// IslandsSettings::validate_for().
IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr);
/// As above, for an objective problem, whose samples are empty: each island gives an estimate for each generation.
IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr);

/// Returns "island[0]", "island[1]", ...: the names of processes that a netlist declares as island[n].
std::vector<std::string> island_names(std::size_t islands);
/// Returns the streams of a run, named as by island_names().
std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands);

} // namespace placedpar
