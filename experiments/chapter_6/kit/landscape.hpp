#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"
#include "problems/plant/plant_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// The sum of the squared errors of strings of the plant over a window, by its moments: the error is linear in the
/// plant's weights, so that a string costs no walk through the window.
class WindowMoments {
public:
    /// REQUIRES: samples of plant_channels numbers, one at least.
    explicit WindowMoments(std::span<const Sample> window);

    /// sum of e^2 of a string of the plant's problem, in its own coding.
    double squared_error(const Genome& genome) const;

private:
    PlantProblem problem_;
    std::size_t channels_;
    std::vector<double> products_; ///< channels x channels: sums of products of two channels
};

/// What a fitness landscape over all strings of a reading is like, for a search that sees one bit further.
struct LandscapeFacts {
    double fit_percent;     ///< of the strings whose fitness, sum(B - e^2), is positive
    std::size_t minima;     ///< strings with no better one among those that differ in one bit
    double optimum_percent; ///< of the strings from which steepest one-bit descent ends at the least error of all
    double good_percent;    ///< of those from which it ends within .1 of the true pole
    double good_strings;    ///< how many strings are within .1 of it
    double correlation;     ///< of log error with the bit difference from the nearest of the best strings
};

/// By enumeration of every string over the window that is there at generation 0 of the record of this seed.
/// REQUIRES: a reading of at most 24 bits.
LandscapeFacts enumerate_landscape(const Recoding& reading, std::uint64_t seed);

} // namespace placedpar
