#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace placedpar {

/// The fitness of an individual is the sum of B - E^2 over the samples of the window (thesis eq. 3.9 and 4.1; eq. 1.7
/// and 5.2 omit the square).
///
/// The sum must not depend on which process evaluates which part of the window, nor on the order in which the parts are
/// added. So each term is rounded to a multiple of 2^-20 and limited to +-2^23. A sum of at most 1024 such terms is a
/// multiple of 2^-20 and at most 2^33 in size, so a double holds it exactly. INVARIANT: the sum of up to
/// `exact_fitness_terms` terms is the same, bit for bit, in whatever groups and in whatever order they are added.
/// Rounding changes a term by at most 5e-7, which is small beside B = 400.
inline constexpr double fitness_quantum = 0x1p-20;
inline constexpr double fitness_term_limit = 0x1p23;
inline constexpr std::size_t exact_fitness_terms = 1024;

/// 1.5 * 2^32. Adding and then subtracting this constant rounds a term to the nearest multiple of 2^-20, ties to even,
/// because neighbouring doubles between 2^32 and 2^33 are 2^-20 apart. This needs IEEE arithmetic, so never
/// -ffast-math.
inline constexpr double fitness_rounding_shift = 0x1.8p32;

/// Returns one sample's term of the fitness, for one individual (T is double) or for several (T is Lanes). `bias` is in
/// the unit of the squared error. If the error is infinite or NaN, the term is -`fitness_term_limit`.
template <typename T = double>
T fitness_term(double bias, const std::type_identity_t<T>& error) {
    using std::max, std::min;
    T term = bias - error * error;
    term = max(T(-fitness_term_limit), term); // with the arguments in this order, NaN becomes the limit
    term = min(T(fitness_term_limit), term);
    return (term + fitness_rounding_shift) - fitness_rounding_shift;
}

} // namespace placedpar
