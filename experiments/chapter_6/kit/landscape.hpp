#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"
#include "problems/plant/plant_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// Computes the sum of squared errors of the plant's strings over a window from its moments. The error is linear in the
/// plant's weights, so no string needs a pass through the window.
class WindowMoments {
public:
    /// REQUIRES: at least one sample, each of plant_channels numbers.
    explicit WindowMoments(std::span<const Sample> window);

    /// Returns the sum of e^2 for a string of the plant's problem, in its own coding.
    double squared_error(const Genome& genome) const;

private:
    PlantProblem problem_;
    std::size_t channels_;
    std::vector<double>
        products_; ///< channels x channels: for each pair of channels, the sum of products over the window
};

/// Properties of the fitness landscape over all strings of a reading, for a search that looks one bit ahead.
struct LandscapeFacts {
    double fit_percent;     ///< strings with positive fitness, sum(B - e^2)
    std::size_t minima;     ///< strings without a better one among those that differ in one bit
    double optimum_percent; ///< strings from which steepest one-bit descent ends at the least error of all
    double good_percent;    ///< strings from which it ends within .1 of the true pole
    double good_strings;    ///< number of strings within .1 of the true pole
    double correlation;     ///< of the log error with the bit difference from the nearest of the best strings
};

/// The "don't care" bits of thesis 6.2: the lowest bits of each of the five parameters of 7 bits.
inline constexpr std::size_t low_bits = 3;

/// Returns the fitness of all 2^15 strings that differ from the string nearest to the plant only in "don't care" bits,
/// over the window at generation 0 of the record of this seed with white noise.
std::vector<double> fitness_by_low_bits(double noise, std::uint64_t seed);

/// Evaluates every string over the window at generation 0 of the record of this seed. REQUIRES: a reading of at most 24
/// bits.
LandscapeFacts enumerate_landscape(const Recoding& reading, std::uint64_t seed);

} // namespace placedpar
