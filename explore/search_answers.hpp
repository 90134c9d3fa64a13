#pragma once

#include "gaprocs/search_observer.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// The best individual of one search in one generation.
struct SearchAnswer {
    Time time; ///< simulated time at which the generation was complete
    double fitness;
    std::vector<double> values; ///< the decoded parameters
};

/// Keeps the best individual of every generation of the searches of a run.
class SearchAnswers final : public SearchObserver {
public:
    /// `searches` has the names of the searching processes. REQUIRES: all these processes search `problem`.
    SearchAnswers(std::vector<std::string> searches, std::shared_ptr<const SearchProblem> problem);

    /// Throws std::invalid_argument for a process that is not in searches().
    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration&) override {}
    void observe(const ObservedAnswer&) override {}

    const std::vector<std::string>& searches() const { return searches_; }
    const SearchProblem& problem() const { return *problem_; }
    /// Returns the number of generations that every search has completed.
    std::size_t generations() const;

    // These functions require generation < generations(). Generations are counted from 0.

    const SearchAnswer& of(std::size_t search, std::size_t generation) const { return answers_[search][generation]; }
    /// Returns the index of the search with the greatest fitness; if several have it, the first.
    std::size_t fittest(std::size_t generation) const;
    /// Returns how far the searches disagree: the difference between the greatest and the least value that they found
    /// for this parameter.
    double spread(std::size_t generation, std::size_t parameter) const;
    /// Returns the time at which the last of the searches had completed the generation.
    Time ready(std::size_t generation) const;

private:
    std::vector<std::string> searches_;
    std::shared_ptr<const SearchProblem> problem_;
    std::vector<std::vector<SearchAnswer>> answers_; ///< [search][generation]
};

} // namespace placedpar
