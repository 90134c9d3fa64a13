#pragma once

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/search.hpp"
#include "runtime/fingerprint.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Tracks a search over several runs, each of which continues from the checkpoint of the run before. For each
/// generation, call passes_over(). If it returns false, call note_population(), evaluate and breed, then call
/// note_best() and keep().
class SearchProgress {
public:
    /// Puts the search into the state of the checkpoint of this name, if there is one. Throws what Search::go_on_from()
    /// throws. `checkpoints` is null if the search starts from the beginning and its state is not stored.
    SearchProgress(Search&, std::string name, Checkpoints* checkpoints);

    /// Skips the next generation if an earlier run has made it. Returns whether the generation was skipped.
    bool passes_over() { return to_pass_over_ > 0 && to_pass_over_-- > 0; }
    /// Throws UserError if this run, which has ended, has not even skipped all generations of the earlier run.
    void require_passed(const Search&) const;

    void note_population(const Search&);
    /// Notes the best individual of the generation. Returns whether it is the fittest of all generations so far.
    bool note_best(const Search&);
    /// Stores the state of the search if a checkpoint is due.
    void keep(const Search&) const;

    /// Returns the fittest individual of all generations, including generations of earlier runs; nothing before the
    /// first generation.
    const std::optional<Individual>& best() const { return best_; }
    /// Returns a hash over the populations of all generations in order. Equal hashes show that a continued run equals
    /// an unbroken run.
    std::uint64_t populations() const { return populations_.value(); }

private:
    std::string name_;
    Checkpoints* checkpoints_;
    std::uint64_t to_pass_over_ = 0; ///< number of generations still to be skipped
    std::optional<Individual> best_;
    std::vector<Improvement> improvements_;
    Fingerprint populations_;
};

} // namespace placedpar
