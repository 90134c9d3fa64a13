#pragma once

#include "runtime/random.hpp"
#include "runtime/transputer/fpu.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace placedpar::test {

inline constexpr std::array all_lengths{transputer::Length::real32, transputer::Length::real64};
inline constexpr std::array all_modes{transputer::Rounding::nearest, transputer::Rounding::zero,
                                      transputer::Rounding::plus, transputer::Rounding::minus};

template <typename T>
constexpr transputer::Length length_of_type = sizeof(T) == 4 ? transputer::Length::real32 : transputer::Length::real64;

template <typename T>
transputer::Real real(T value) {
    return {transputer::RealPattern<T>::of(value).word(), length_of_type<T>};
}

template <typename T>
transputer::Real real_with_bits(std::uint64_t bits) {
    return {bits, length_of_type<T>};
}

/// Returns zeros, denormals, the ends of ranges, halves and their neighbours, integers' limits, infinities and NaNs, of
/// both signs.
std::vector<transputer::Real> special_reals(transputer::Length length);

/// Draws reals so that ties, cancellation, overflow, underflow and denormals are frequent.
class RandomReals {
public:
    RandomReals(std::uint64_t seed, transputer::Length length) : random_(seed, "reals"), length_(length) {}

    /// Returns a finite number.
    transputer::Real finite();
    /// Returns a finite number whose sum, product or quotient with `other` is often at a limit.
    transputer::Real finite_beside(transputer::Real other);

private:
    std::uint64_t below(std::uint64_t count) { return random_() % count; }
    std::uint64_t fraction();
    transputer::Real with_exponent(std::int64_t exponent);

    RandomStream random_;
    transputer::Length length_;
};

} // namespace placedpar::test
