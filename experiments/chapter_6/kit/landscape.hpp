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
/// plant's weights. So the sum can be computed fast from products of the window's channels, without a pass through the
/// samples.
class WindowMoments {
public:
    /// REQUIRES: at least one sample; each sample has `plant_channels` numbers.
    explicit WindowMoments(std::span<const Sample> window);

    /// Returns the sum of e^2 for a string in the coding of the plant's problem.
    double squared_error(const Genome& genome) const;

private:
    PlantProblem problem_;
    std::size_t channels_;
    std::vector<double> products_; ///< for each pair of channels, the sum of their products over the window
};

/// Properties of the fitness landscape of a coding of the plant. Percentages are of all strings.
struct LandscapeFacts {
    double fit_percent;     ///< strings with positive fitness sum(B - e^2)
    std::size_t minima;     ///< strings that no change of one bit improves
    double optimum_percent; ///< strings from which steepest descent by single bits ends at the least error of all
                            ///< strings
    double good_percent;    ///< strings from which steepest descent by single bits ends within .1 of the true pole
    double good_strings;    ///< number of strings within .1 of the true pole
    double correlation;     ///< correlation of the logarithm of the error with the number of bits that differ from the
                            ///< nearest best string
};

/// The number of "don't care" bits of section 6.2: the lowest bits of each of the five parameters of 7 bits.
inline constexpr std::size_t low_bits = 3;

/// Returns the fitness of all 2^15 strings that differ only in "don't care" bits from the string nearest to the plant.
/// The fitness is over the window at generation 0 of the measurements of this seed, with white noise of the standard
/// deviation `noise`.
std::vector<double> fitness_by_low_bits(double noise, std::uint64_t seed);

/// Evaluates every string over the window at generation 0 of the record of this seed. REQUIRES: the reading has at most
/// 24 bits.
LandscapeFacts enumerate_landscape(const Recoding& reading, std::uint64_t seed);

} // namespace placedpar
