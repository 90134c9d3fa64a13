#pragma once

#include "gaprocs/recoding.hpp"
#include "gaprocs/search_problem.hpp"
#include "problems/plant/plant_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// Computes the sum of squared errors over a window for strings of the plant's problem. The error is linear in the
/// plant's weights, so the moments of the window suffice; no string needs a pass through the samples.
class WindowMoments {
public:
    /// REQUIRES: at least one sample; each sample has `plant_channels` numbers.
    explicit WindowMoments(std::span<const Sample> window);

    /// Returns the sum of e^2 for a string of the plant's problem, in its own coding.
    double squared_error(const Genome& genome) const;

private:
    PlantProblem problem_;
    std::size_t channels_;
    std::vector<double> products_; ///< for each pair of channels, the sum of their products over the window
};

/// Properties of the fitness landscape of all strings of a reading. Percentages are of all strings.
struct LandscapeFacts {
    double fit_percent;     ///< strings with positive fitness sum(B - e^2)
    std::size_t minima;     ///< strings that no change of one bit improves
    double optimum_percent; ///< strings from which steepest descent by single bits ends at the least error of all
                            ///< strings
    double good_percent;    ///< strings from which this descent ends within .1 of the true pole
    double good_strings;    ///< number of strings within .1 of the true pole
    double correlation;     ///< between the logarithm of the error and the number of bits that differ from the nearest
                            ///< best string
};

/// The number of "don't care" bits of thesis 6.2: the lowest bits of each of the five parameters of 7 bits.
inline constexpr std::size_t low_bits = 3;

/// Returns the fitness of all 2^15 strings that differ only in "don't care" bits from the string nearest to the plant.
/// The window is that at generation 0 of the record of this seed, with white noise.
std::vector<double> fitness_by_low_bits(double noise, std::uint64_t seed);

/// Evaluates every string over the window at generation 0 of the record of this seed. REQUIRES: a reading of at most 24
/// bits.
LandscapeFacts enumerate_landscape(const Recoding& reading, std::uint64_t seed);

} // namespace placedpar
