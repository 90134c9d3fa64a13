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

    /// Throws UserError: as those of the islands for this record, as Topology::neighbours(), for more emigrants than an
    /// island has individuals, for more immigrants at once than it can accept, and for islands of different numbers of
    /// generations per sample.
    void validate_for(std::size_t record_length) const;
    /// What is allowed, but hardly meant: a topology in parts that exchange nothing with each other, or where the
    /// individuals of an island never come to another. "" if nothing is.
    /// Throws as Topology::neighbours().
    std::string warning() const;
};

/// An individual on its way.
struct Migration {
    std::uint64_t generation; ///< after whose evaluation it left, from 1
    std::size_t from, to;
    /// With its fitness in the window of the island to which it comes; among the offspring, where that is not known
    /// before the next generation, in the window from which it comes.
    Individual individual;
    std::optional<std::size_t> place; ///< the index of the one that it replaces; nothing where it is turned away

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// Immigrants come in, in their order, and their places are noted; the island breeds. Those who do not come among the
/// offspring must have their fitness in this island's window. Throws as Search::accept() and next_generation().
void accept_and_breed(Search&, std::span<double> fitness, std::span<Migration> arrivals, const Acceptance&);

/// Several searches over the same record, generation by generation in step: all are evaluated; emigrants leave; each
/// island accepts its immigrants, those of the island of lowest number first; all breed. Nothing depends on an order
/// in which islands take their turns: each draws from a stream of its own, and all emigrants are chosen before the
/// first immigrant is accepted. Islands that may hear of each other begin together, when all have enough samples.
///
/// An immigrant's fitness is found anew in the window of its new island. Where both have the same window that changes
/// nothing: fitness is exact (gaprocs/fitness.hpp). Immigrants among the offspring are evaluated one generation later.
///
/// With the asynchronous schedule no island waits: without a machine and its times, islands take turns, and in each
/// generation island 0 evaluates, sends, takes in who has come so far and breeds, then island 1, and so on.
class Islands {
public:
    /// A stream for each island, which draws the first population from it. `problem` must outlive this. Throws as
    /// IslandsSettings::validate_for() for a record of any length and settings_for(), and std::invalid_argument for
    /// another number of streams.
    Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams);

    /// From now on the observer is told of every generation, of the islands by their island_names(). It outlives this.
    void observe_by(SearchObserver& observer);

    /// A new sample comes into the windows of all.
    void push(const Sample& sample);
    /// Enough samples for a generation on this island? One of a short window waits for those that it is in step with.
    bool ready(std::size_t island) const;
    /// On some island?
    bool ready() const;
    /// Of the islands that are ready.
    void next_generation();

    const std::vector<Search>& searches() const { return searches_; }
    /// Of the last next_generation(), by the islands to which they came, for each in the order in which they were
    /// accepted; empty when none was due.
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
    std::vector<std::vector<std::size_t>> in_step_; ///< with each island, those with which it begins, itself included
    std::vector<SlidingWindow> windows_;
    std::vector<Search> searches_;
    std::vector<std::vector<double>> fitness_; ///< fitness in this generation, by island and individual
    std::vector<Migration> migrations_;
    /// Asynchronous: on their way to each island, by the island from which they come.
    std::vector<std::map<std::size_t, std::vector<Migration>>> mail_;
    SearchObserver* observer_ = nullptr;
    std::vector<std::string> names_; ///< by which the observer knows the islands
};

struct IslandsResult {
    std::vector<SearchResult> islands;
    std::vector<Migration> migrations; ///< migrations of all generations, in order
};

/// The islands over a record, without processes, machine or time. Throws as Islands and
/// IslandsSettings::validate_for().
IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr);
/// The same for an objective problem, whose record is empty samples: an estimate of each island for each generation.
IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams, SearchObserver* observer = nullptr);

/// "island[0]", "island[1]", ..., as processes that a netlist declares by island[n].
std::vector<std::string> island_names(std::size_t islands);
/// The streams of a run, of these names.
std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands);

} // namespace placedpar
