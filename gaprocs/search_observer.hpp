#pragma once

#include "gaprocs/objective.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"
#include "gaprocs/search.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace placedpar {

class SearchProblem; // gaprocs/search_problem.hpp

/// A generation in which the fittest individual of all generations so far changed.
struct Improvement {
    std::uint64_t generation = 0;
    double fitness = 0;

    friend bool operator==(const Improvement&, const Improvement&) = default;
};

/// An evaluated generation before it breeds. Its population includes the immigrants that were accepted before breeding.
/// Immigrants that replace new offspring belong to the next generation.
struct ObservedGeneration {
    std::string_view search; ///< name of the process; without processes, "traditional" or a name such as "island[2]"
    std::uint64_t number;    ///< from 1
    /// Simulated time at which the breeding after this generation ends; nothing without a simulated machine.
    std::optional<Time> time;
    const Representation& representation;
    std::span<const Genome> population;
    std::span<const double> fitness; ///< one for each individual
    std::optional<Goal> goal = {};   ///< goal of the objective, if the problem has an objective; Goal::minimise: the
                                     ///< fitness is the negated objective
};

/// An individual that came to an island.
struct ObservedMigration {
    std::string_view from, to;
    std::uint64_t generation; ///< generation of the search `to`, from 1
    std::optional<Time> time; ///< simulated time; nothing without a simulated machine
    double fitness; ///< fitness on the new island, or, if it has not been evaluated there yet, on the old island
    bool accepted;  ///< false: rejected
};

/// The answer of an analyst, which chooses one of several searches: the best individual of the chosen search.
struct ObservedAnswer {
    std::string_view analyst, chosen; ///< names of the analyst and of the chosen search
    std::uint64_t generation;         ///< generation of the searches, from 1
    std::optional<Time> time;
    std::span<const std::string> names; ///< names of the parameters
    std::span<const double> values;     ///< values of the parameters
};

/// Receives the events of all searches of a run, for logs and plots. An observer must not affect the searches.
///
/// 1. The generations of a search are reported in order, without gaps.
/// 2. The immigrants of a generation are reported between this generation and the next generation of the same search,
/// in the order in which they were accepted or rejected.
/// 3. The order of events of different searches is not specified.
/// 4. References and views in the arguments are valid only during the call.
class SearchObserver {
public:
    virtual void observe(const ObservedGeneration&) = 0;
    virtual void observe(const ObservedMigration&) = 0;
    /// The answers of an analyst are reported in the order of the generations.
    virtual void observe(const ObservedAnswer&) = 0;

protected:
    ~SearchObserver() = default;
};

/// Passes the events of searches in several threads to an observer, one event at a time, so that the observer need not
/// be thread-safe.
class OneEventAtATime final : public SearchObserver {
public:
    /// REQUIRES: the observer outlives this object.
    explicit OneEventAtATime(SearchObserver& observer) : observer_(observer) {}
    void observe(const ObservedGeneration& event) override { pass(event); }
    void observe(const ObservedMigration& event) override { pass(event); }
    void observe(const ObservedAnswer& event) override { pass(event); }

private:
    void pass(const auto& event) {
        const std::lock_guard lock(mutex_);
        observer_.observe(event);
    }

    SearchObserver& observer_;
    std::mutex mutex_;
};

/// Returns a listener for Search::listen() that passes generations to an observer. `now` returns the simulated time;
/// null without a simulated machine. REQUIRES: the observer outlives the search.
Search::Listener told_to(SearchObserver& observer, std::string search, const SearchProblem&, Time (*now)() = nullptr);

} // namespace placedpar
