#pragma once

#include <cstdint>

namespace placedpar::transputer {

/// The registers that the T414's and T425's instructions for REAL32 arithmetic work on. These processors have no
/// floating-point unit: a library multiplies with the instructions `unpacksn` (twice), `lmul`, `norm`, `postnormsn` and
/// `roundsn`, and adds the sign itself. The effects are the same as in the public emulators pahihu/t4 and TVM. With
/// these effects such a library gives the results of IEEE 754, rounded to nearest.
struct SingleLengthRegisters {
    std::uint32_t a = 0, b = 0, c = 0;

    friend bool operator==(const SingleLengthRegisters&, const SingleLengthRegisters&) = default;
};

/// The class of a real, which `unpacksn` adds to 4 * B in C.
enum class SingleLengthClass : std::uint32_t { zero = 0, finite = 1, infinite = 2, nan = 3 };

/// Unpacks the REAL32 in A. A := its fraction, with the hidden bit at the top; B := its exponent, 1 for a denormal;
/// C := 4 * B + its class. The sign is dropped.
SingleLengthRegisters unpacksn(SingleLengthRegisters);

/// Corrects the exponent after `norm`. B:A is the fraction, C the places by which `norm` shifted it. C := the exponent
/// in the workspace word (W+0) minus C, at most 255. An exponent of 0 or less gives a denormal: B:A is shifted right,
/// but the ones of A also stay where they were, so that `roundsn` detects lost bits; C := 0. An exponent below -31
/// gives zeros.
SingleLengthRegisters postnormsn(SingleLengthRegisters, std::uint32_t workspace);

/// Packs B (the fraction, its top bit dropped) and C (the exponent) into A, rounded to the nearest, ties to even. A and
/// the lowest 8 bits of B determine the rounding. An exponent of 255 or more gives infinity.
SingleLengthRegisters roundsn(SingleLengthRegisters);

/// Pushes infinity.
SingleLengthRegisters ldinf(SingleLengthRegisters);

/// Returns whether `cflerr` sets Error: A is an infinity or a NaN.
bool cflerr(SingleLengthRegisters);

} // namespace placedpar::transputer
