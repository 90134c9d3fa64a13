#pragma once

#include "gaprocs/objective.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"
#include "gaprocs/search.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace placedpar {

class SearchProblem; // gaprocs/search_problem.hpp

/// An evaluated generation before it breeds, with its immigrants, except those that come among the offspring.
struct ObservedGeneration {
    std::string_view search;  ///< name of the process; in the library "traditional" or "island[2]"
    std::uint64_t number;     ///< from 1
    std::optional<Time> time; ///< virtual time at which its genetic operators are done; nothing in the library
    const Representation& representation;
    std::span<const Genome> population;
    std::span<const double> fitness; ///< one for each individual
    std::optional<Goal> goal =
        {}; ///< goal of an objective problem; where the objective is minimised, the fitness is its negative
};

/// An immigrant that was accepted or turned away.
struct ObservedMigration {
    std::string_view from, to;
    std::uint64_t generation; ///< generation of the search `to`, from 1
    std::optional<Time> time; ///< as in ObservedGeneration
    double fitness;           ///< fitness of Migration::individual (gaprocs/islands.hpp)
    bool accepted;            ///< false: turned away
};

/// The one answer of several searches, as ActiveErrorAnalysis gives it.
struct ObservedAnswer {
    std::string_view analyst, chosen; ///< names of the analyst, and of the search whose best is the answer
    std::uint64_t generation;         ///< generation of the searches, from 1
    std::optional<Time> time;
    std::span<const std::string> names; ///< names of its parameters
    std::span<const double> values;     ///< one for each
};

/// Receives events of the searches of one run at a time. It must not affect them.
///
/// 1. The generations of a search come in their order, none is left out. 2. The immigrants of a generation are observed
/// after it and before the next generation of their search, in the order in which they
///    were accepted or turned away.
/// 3. The order between different searches of a run is not specified. 4. References and views in the arguments are
/// valid only during the call.
///
/// Without an observer, a search pays a comparison with null in each generation (Search::listen).
class SearchObserver {
public:
    virtual void observe(const ObservedGeneration&) = 0;
    virtual void observe(const ObservedMigration&) = 0;
    /// Tells an answer of an analyst; its answers come in the order of their generations.
    virtual void observe(const ObservedAnswer&) = 0;

protected:
    ~SearchObserver() = default;
};

/// Returns a listener for Search::listen() that passes generations to an observer. `now` returns the time; null in the
/// library. REQUIRES: the observer outlives the search.
Search::Listener told_to(SearchObserver& observer, std::string search, const SearchProblem&, Time (*now)() = nullptr);

} // namespace placedpar
