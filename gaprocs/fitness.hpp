#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace placedpar {

/// The fitness of an individual is the sum over the window of B - E^2 (thesis eq. 3.9 and 4.1, with the
/// square that 1.7 and 5.2 leave out).
///
/// So that the sum does not depend on which process evaluates which part of the window, nor on the order in which
/// the parts are added, each term is rounded to a multiple of 2^-20 and clamped to +-2^23. A sum of up to 1024 such
/// terms is a multiple of 2^-20 below 2^33 in size, which a double holds exactly: INVARIANT: any partition and any
/// order of up to `exact_fitness_terms` terms give the same bits. Rounding costs at most 5e-7 a term, of B = 400.
inline constexpr double fitness_quantum = 0x1p-20;
inline constexpr double fitness_term_limit = 0x1p23;
inline constexpr std::size_t exact_fitness_terms = 1024;

/// Between 2^32 and 2^33 neighbouring doubles are 2^-20 apart: adding and taking away 1.5 * 2^32 rounds to
/// nearest, ties to even; the limits stay what they are. Needs IEEE arithmetic, so never -ffast-math.
inline constexpr double fitness_rounding_shift = 0x1.8p32;

/// Returns one sample's term of the fitness of one individual, or of several (T is double or Lanes). `bias` and `error`
/// squared are in the same unit, the problem's own. An error that is not a number, or infinite, gives the lower limit.
template <typename T = double>
T fitness_term(double bias, const std::type_identity_t<T>& error) {
    using std::max, std::min;
    T term = bias - error * error;
    term = max(T(-fitness_term_limit), term); // in this order NaN is caught too
    term = min(T(fitness_term_limit), term);
    return (term + fitness_rounding_shift) - fitness_rounding_shift;
}

} // namespace placedpar
