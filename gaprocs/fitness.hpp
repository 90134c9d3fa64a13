#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace placedpar {

/// The fitness of an individual is the sum of B - E^2 over the samples of a window, the newest measurements. E is the
/// error of the individual's model at a sample, and B a constant, the bias (thesis eq. 3.9 and 4.1; eq. 1.7 and 5.2
/// omit the square).
///
/// Parallel processes may each evaluate a part of the window. The sum must not depend on these parts, or on the order
/// in which they are added. So each term is rounded to a multiple of 2^-20 and limited to +-2^23. A sum of at most 1024
/// such terms is a multiple of 2^-20 and at most 2^33 in size, so a double holds it exactly. INVARIANT: the sum of up
/// to `exact_fitness_terms` terms is the same, bit for bit, in any grouping and any order of the additions. Rounding
/// changes a term by at most 5e-7, which is small beside the usual B = 400.
inline constexpr double fitness_quantum = 0x1p-20;
inline constexpr double fitness_term_limit = 0x1p23;
inline constexpr std::size_t exact_fitness_terms = 1024;

/// 1.5 * 2^32. Adding and then subtracting this constant rounds a term to the nearest multiple of 2^-20, ties to even,
/// because neighbouring doubles between 2^32 and 2^33 are 2^-20 apart. This needs IEEE arithmetic, so never compile
/// with -ffast-math.
inline constexpr double fitness_rounding_shift = 0x1.8p32;

/// Returns B - E^2 for one sample, rounded and limited as above. T is double for one individual, or Lanes, a vector of
/// doubles, for several individuals at once. `bias` is B, in the unit of the squared error. If the error is infinite or
/// NaN, the term is -`fitness_term_limit`.
template <typename T = double>
T fitness_term(double bias, const std::type_identity_t<T>& error) {
    using std::max, std::min;
    T term = bias - error * error;
    term = max(T(-fitness_term_limit), term); // with the arguments in this order, NaN becomes the limit
    term = min(T(fitness_term_limit), term);
    return (term + fitness_rounding_shift) - fitness_rounding_shift;
}

} // namespace placedpar
