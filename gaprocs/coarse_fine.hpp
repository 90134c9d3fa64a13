#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/window.hpp"

#include <cstdint>
#include <vector>

namespace placedpar {

/// The settings of a pair of searches, "coarse" and "fine" (thesis 6.2, Figure 6.6).
struct CoarseFineSettings {
    SearchSettings coarse, fine;        ///< settings of the two searches, which must have the same window
    Recoding coarse_reading;            ///< number of most significant bits of each field that the coarse search breeds
    std::vector<std::size_t> fine_bits; ///< number of bits of each field in the fine search; a field that has all bits
                                        ///< of the problem's field ignores the bias point
};

/// Runs two searches over the same record. The coarse search has a coarse grid. The fine search has the problem's own
/// grid, but only around the bias point, the best individual of the coarse search in the same generation. So when the
/// bias point moves, the parameters of all individuals of the fine search move, too. The thesis does not say from which
/// generation the bias point comes; taking it from the same generation is our choice.
class CoarseFine {
public:
    /// REQUIRES: the strings of `problem` are in natural binary, and `problem` outlives the pair. Throws what
    /// SearchSettings::validate() and Recoding::validate() throw. Throws std::invalid_argument if the two searches have
    /// different windows.
    CoarseFine(const SearchProblem& problem, const CoarseFineSettings& settings, std::uint64_t seed);

    void push(Sample sample) { window_.push(std::move(sample)); }
    bool ready() const { return window_.ready(); }
    /// Makes one generation of both searches. REQUIRES: ready().
    void next_generation();

    const Search& coarse() const { return coarse_; }
    const Search& fine() const { return fine_; }
    /// Return the best individual of the last generation, as a string that the problem reads. REQUIRES:
    /// next_generation() was called.
    const Individual& coarse_best() const { return coarse_best_; }
    const Individual& fine_best() const { return fine_best_; }

private:
    /// Evaluates and breeds one generation of a search. Returns the best individual, as a string that the problem
    /// reads.
    Individual evaluate_and_breed(Search& search, const Recoding& reading);

    const SearchProblem& problem_;
    double bias_;
    SlidingWindow window_;
    Recoding coarse_reading_, fine_reading_;
    Search coarse_, fine_;
    Individual coarse_best_, fine_best_;
};

} // namespace placedpar
