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

/// A generation as it is about to breed: evaluated, its immigrants settled, but for those who come among the offspring.
struct ObservedGeneration {
    std::string_view search;  ///< the process; in the library "traditional" or "island[2]"
    std::uint64_t number;     ///< from 1
    std::optional<Time> time; ///< virtual, when its genetic operators are done; none in the library
    const Representation& representation;
    std::span<const Genome> population;
    std::span<const double> fitness; ///< one for each individual
    std::optional<Goal> goal =
        {}; ///< goal of an objective problem; where the objective is minimised, the fitness is its negative
};

/// What became of an immigrant.
struct ObservedMigration {
    std::string_view from, to;
    std::uint64_t generation; ///< generation of the search `to`, from 1
    std::optional<Time> time; ///< as above
    double fitness;           ///< Migration::individual's (gaprocs/islands.hpp)
    bool accepted;            ///< else turned away
};

/// The one answer of several searches, as ActiveErrorAnalysis gives it.
struct ObservedAnswer {
    std::string_view analyst, chosen; ///< processes; the second is that whose best is the answer
    std::uint64_t generation;         ///< generation of the searches, from 1
    std::optional<Time> time;
    std::span<const std::string> names; ///< names of its parameters
    std::span<const double> values;     ///< one for each
};

/// Is told what happens in searches, of one run at a time. It must change nothing.
///
/// 1. The generations of a search come in their order, none is left out.
/// 2. Immigrants of a generation are told of after it, before the next one of their search, in the order in which they
///    were accepted or turned away.
/// 3. In what order the searches of a run come is not said: processes go on when they can.
/// 4. What is referred to may be gone after the call.
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

/// What Search::listen() takes, for an observer: `now` gives the time, and is null in the library. REQUIRES: the
/// observer outlives the search.
Search::Listener told_to(SearchObserver& observer, std::string search, const SearchProblem&, Time (*now)() = nullptr);

} // namespace placedpar
