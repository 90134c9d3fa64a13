#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/window.hpp"

#include <cstdint>
#include <vector>

namespace placedpar {

/// The settings of a pair: a "coarse" genetic algorithm and a "fine" one (thesis 6.2, Figure 6.6).
struct CoarseFineSettings {
    SearchSettings coarse, fine;        ///< both have the same window
    Recoding coarse_reading;            ///< selects the most significant bits of the problem's fields
    std::vector<std::size_t> fine_bits; ///< bits of each field in the fine search; a field with all of the problem's
                                        ///< bits is searched without the bias point
};

/// Two searches over the same record. The coarse search has a coarse grid. The fine search has the problem's own grid,
/// but only around the bias point, which is the best individual of the coarse search. The bias point comes from the
/// coarse population of the same generation, so the fine population moves with it. The thesis does not specify this;
/// the choice is ours.
class CoarseFine {
public:
    /// REQUIRES: `problem` is in natural binary and outlives the pair. Throws as SearchSettings::validate() and
    /// Recoding::validate(). Throws std::invalid_argument if the two searches have different windows.
    CoarseFine(const SearchProblem& problem, const CoarseFineSettings& settings, std::uint64_t seed);

    /// Adds a new sample to the window.
    void push(Sample sample) { window_.push(std::move(sample)); }
    bool ready() const { return window_.ready(); }
    /// Makes one generation of both searches. REQUIRES: ready().
    void next_generation();

    const Search& coarse() const { return coarse_; }
    const Search& fine() const { return fine_; }
    /// Return the best individual of the last generation as a string of the problem. REQUIRES: next_generation() was
    /// called.
    const Individual& coarse_best() const { return coarse_best_; }
    const Individual& fine_best() const { return fine_best_; }

private:
    /// Evaluates and breeds one generation. Returns its best individual as a string of the problem.
    Individual evaluate_and_breed(Search& search, const Recoding& reading);

    const SearchProblem& problem_;
    double bias_;
    SlidingWindow window_;
    Recoding coarse_reading_, fine_reading_;
    Search coarse_, fine_;
    Individual coarse_best_, fine_best_;
};

} // namespace placedpar
