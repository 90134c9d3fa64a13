#pragma once

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// Islands that search side by side; by default a ring in which every third generation the best of each replaces the
/// worst of the next.
struct IslandsSettings {
    /// One for each island: populations, rates and windows may differ, generations per sample may not.
    std::vector<SearchSettings> islands;
    Topology topology;
    Schedule schedule;
    Emigration emigration;
    Acceptance acceptance;

    /// Throws UserError: as those of the islands for this record, as Topology::neighbours(), for more emigrants than an
    /// island has individuals, and for islands of different numbers of generations per sample.
    void validate_for(std::size_t record_length) const;
};

/// An individual on its way.
struct Migration {
    std::uint64_t generation; ///< after whose evaluation it left, from 1
    std::size_t from, to;
    Individual individual;            ///< with its fitness in the window of the island to which it comes
    std::optional<std::size_t> place; ///< the index of the one that it replaces; nothing where it is turned away

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// Several searches over the same record, generation by generation in step: all are evaluated; emigrants leave; each
/// island accepts its immigrants, those of the island of lowest number first; all breed. Nothing depends on an order
/// in which islands take their turns: each draws from a stream of its own, and all emigrants are chosen before the
/// first immigrant is accepted.
///
/// An immigrant's fitness is found anew in the window of its new island. Where both have the same window that changes
/// nothing: fitness is exact (gaprocs/fitness.hpp).
class Islands {
public:
    /// A stream for each island, which draws the first population from it. `problem` must outlive this. Throws as
    /// IslandsSettings::validate_for() for a record of any length and settings_for(), and std::invalid_argument for
    /// another number of streams.
    Islands(const SearchProblem& problem, IslandsSettings settings, std::vector<RandomStream> streams);

    /// A new sample comes into the windows of all.
    void push(const Sample& sample);
    /// Enough samples for a generation on every island? Those of short windows wait for the others.
    bool ready() const;
    /// Throws UserError when more immigrants come to an island at once than it can accept. REQUIRES: ready().
    void next_generation();

    const std::vector<Search>& searches() const { return searches_; }
    /// Of the last next_generation(), in the order in which they were accepted; empty when none was due.
    const std::vector<Migration>& migrations() const { return migrations_; }

private:
    void evaluate_all();
    void emigrate(std::size_t from);
    void accept(std::size_t island, std::span<Migration> arrivals);

    const SearchProblem& problem_;
    IslandsSettings settings_;
    Neighbours neighbours_;
    std::vector<SlidingWindow> windows_;
    std::vector<Search> searches_;
    std::vector<std::vector<double>> fitness_; ///< of each individual of each island, of this generation
    std::vector<Migration> migrations_;
};

struct IslandsResult {
    std::vector<SearchResult> islands;
    std::vector<Migration> migrations; ///< of all generations, in their order
};

/// The islands over a record, without processes, machine or time. Throws as Islands and
/// IslandsSettings::validate_for().
IslandsResult run_islands(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& settings,
                          std::vector<RandomStream> streams);
/// The same for an objective problem, whose record is empty samples: an estimate of each island for each generation.
IslandsResult run_islands(const SearchProblem& problem, std::size_t generations, const IslandsSettings& settings,
                          std::vector<RandomStream> streams);

/// The streams of a run: "island 0", "island 1", ...
std::vector<RandomStream> island_streams(std::uint64_t seed, std::size_t islands);

} // namespace placedpar
