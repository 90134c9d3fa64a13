#pragma once

#include <cstdint>

namespace placedpar::transputer {

/// The registers A, B and C, for the instructions by which a T414 or T425 computes with REAL32. These processors have
/// no floating-point unit. For example, a library multiplies with the instructions `unpacksn` (twice), `lmul`, `norm`,
/// `postnormsn` and `roundsn`, and adds the sign itself. The instructions have the effects of the public emulators
/// pahihu/t4 and TVM, so such a library gives the results of IEEE 754, rounded to nearest.
struct SingleLengthRegisters {
    std::uint32_t a = 0, b = 0, c = 0;

    friend bool operator==(const SingleLengthRegisters&, const SingleLengthRegisters&) = default;
};

/// The class of a real. `unpacksn` stores 4 * B + the class in C.
enum class SingleLengthClass : std::uint32_t { zero = 0, finite = 1, infinite = 2, nan = 3 };

/// Unpacks the REAL32 in A. A := its fraction, with the hidden bit at the top; B := its exponent, 1 for a denormal;
/// C := 4 * B + its class. The sign is dropped.
SingleLengthRegisters unpacksn(SingleLengthRegisters);

/// Corrects the exponent after `norm`. B:A is the fraction, and C is the number of places by which `norm` shifted it. C
/// := the exponent in the workspace word (W+0) minus C, at most 255. An exponent of 0 or less gives a denormal: B:A is
/// shifted right, and C := 0. The ones of A also stay where they were, so that `roundsn` detects lost bits. An exponent
/// below -31 gives zeros.
SingleLengthRegisters postnormsn(SingleLengthRegisters, std::uint32_t workspace);

/// Packs B (the fraction, its top bit dropped) and C (the exponent) into A, rounded to the nearest, ties to even. A and
/// the lowest 8 bits of B determine the rounding. An exponent of 255 or more gives infinity.
SingleLengthRegisters roundsn(SingleLengthRegisters);

/// Pushes infinity.
SingleLengthRegisters ldinf(SingleLengthRegisters);

/// Returns whether `cflerr` sets Error: A is an infinity or a NaN.
bool cflerr(SingleLengthRegisters);

} // namespace placedpar::transputer
