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
    SearchSettings coarse, fine; ///< both must have the same window
    Recoding coarse_reading; ///< how many of the most significant bits of each field (the bits of one parameter) the
                             ///< coarse search breeds
    std::vector<std::size_t> fine_bits; ///< number of bits of each field in the fine search. A field with as many bits
                                        ///< as in the problem does not depend on the bias point (see CoarseFine)
};

/// Runs two searches over the same record of measurements, a coarse search of the whole range and a fine search near
/// its best point. The coarse search has few values for each parameter. The fine search has all values of the problem,
/// but only around the bias point. The bias point is the best individual of the coarse search in the same generation.
/// When the bias point moves, the parameters of all individuals of the fine search move, too. The thesis does not say
/// from which generation the bias point comes; the same generation is PlacedPar's choice.
class CoarseFine {
public:
    /// REQUIRES: `problem` reads strings in natural binary (not in Gray code or real numbers), and `problem` outlives
    /// the pair. Throws what SearchSettings::validate() and Recoding::validate() throw. Throws std::invalid_argument if
    /// the two searches have different windows.
    CoarseFine(const SearchProblem& problem, const CoarseFineSettings& settings, std::uint64_t seed);

    void push(Sample sample) { window_.push(std::move(sample)); }
    bool ready() const { return window_.ready(); }
    /// Makes one generation of both searches. REQUIRES: ready().
    void next_generation();

    const Search& coarse() const { return coarse_; }
    const Search& fine() const { return fine_; }
    /// Return the best individual of the search's last generation, as a string that the problem reads. REQUIRES:
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
