#pragma once

#include "runtime/transputer/fpu.hpp"

#include <cstdint>

namespace placedpar::test {

/// Exact arithmetic by MPFR, rounded to a length with its range of exponents and denormals.
struct ExactReal {
    transputer::Real real; ///< if the result is a NaN, this may be any NaN
    bool overflow = false;
};

enum class ExactOperation : std::uint8_t {
    add,
    subtract,
    multiply,
    divide,
    remainder,
    root,     ///< root of left; this operation and the next two do not use the right operand
    integer,  ///< left rounded to an integer
    converted ///< left in another length
};

/// Returns the result of `left op right`, rounded to a length.
ExactReal exact(ExactOperation, transputer::Rounding, transputer::Length, transputer::Real left,
                transputer::Real right);

/// Returns left * 2^exponent in the length of `left`.
ExactReal exactly_scaled(transputer::Rounding, transputer::Real left, int exponent);

/// Returns an integer as a real.
ExactReal exact_integer(transputer::Rounding, transputer::Length, std::int64_t integer);

/// Returns the quotient (left - remainder) / right. REQUIRES: it is an integer, and all are finite.
transputer::Real exact_quotient(transputer::Real left, transputer::Real right, transputer::Real remainder);

/// Returns -1, 0 or 1 for left < right, left = right, left > right. REQUIRES: none is a NaN.
int exactly_compared(transputer::Real left, transputer::Real right);

/// Returns whether -2^bits <= real < 2^bits. REQUIRES: no NaN.
bool exactly_within(transputer::Real real, int bits);

/// Returns the lower 32 bits of a finite number rounded down to an integer, in two's complement.
std::uint32_t exact_low_word(transputer::Real real);

} // namespace placedpar::test
