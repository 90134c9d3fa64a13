#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/window.hpp"

#include <cstdint>
#include <vector>

namespace placedpar {

/// A "coarse" genetic algorithm and a "fine" one (thesis 6.2, Figure 6.6).
struct CoarseFineSettings {
    SearchSettings coarse, fine; ///< both have the same window
    Recoding coarse_reading;     ///< the most significant bits of the problem's fields
    std::vector<std::size_t>
        fine_bits; ///< bits of each field; a field with all bits of the problem's is searched without the bias point
};

/// Two searches over the same record: the coarse one on a coarse grid, and the fine one on the problem's own grid,
/// but only around the best of the coarse one, its bias point. Ours, the thesis is silent: the bias point is the best
/// of the coarse population of the same generation, so that the fine population moves with it.
class CoarseFine {
public:
    /// `problem`, read in natural binary, must outlive this. Throws as SearchSettings::validate() and
    /// Recoding::validate(), and std::invalid_argument for windows that are not equal.
    CoarseFine(const SearchProblem& problem, const CoarseFineSettings& settings, std::uint64_t seed);

    /// Adds a new sample to the window.
    void push(Sample sample) { window_.push(std::move(sample)); }
    bool ready() const { return window_.ready(); }
    /// Makes one generation of both searches. REQUIRES: ready().
    void next_generation();

    const Search& coarse() const { return coarse_; }
    const Search& fine() const { return fine_; }
    /// Returns the best of the last generation as a string of the problem, as fine_best() does. REQUIRES: a generation
    /// was made.
    const Individual& coarse_best() const { return coarse_best_; }
    const Individual& fine_best() const { return fine_best_; }

private:
    /// Evaluates and breeds, and returns the best individual as a string of the problem.
    Individual evaluate_and_breed(Search& search, const Recoding& reading);

    const SearchProblem& problem_;
    double bias_;
    SlidingWindow window_;
    Recoding coarse_reading_, fine_reading_;
    Search coarse_, fine_;
    Individual coarse_best_, fine_best_;
};

} // namespace placedpar
