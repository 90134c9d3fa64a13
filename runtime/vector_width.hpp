#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar {

// Code that profits from wide registers is compiled for each width of registers. At run time the program uses the
// widest registers that the processor has. INVARIANT: all widths give the same bits. Therefore compile with
// `-ffp-contract=off`: an instruction that multiplies and adds rounds only once. Google Highway and similar libraries
// cannot be used. Their functions can be called only from code that is marked for a target. An objective function that
// a user writes as a plain struct is not marked, so it could not use wide registers.

/// The possible numbers of doubles in a register: 2 (SSE2, or another processor's own registers), 4 (AVX2), 8
/// (AVX-512).
inline constexpr std::array<std::size_t, 3> vector_widths{2, 4, 8};

/// A register of `width` doubles. There is a specialisation for each width, because GCC 12 miscompiles vectors whose
/// size depends on a parameter.
template <std::size_t width>
struct Registers;
template <>
struct Registers<2> {
    typedef double Doubles __attribute__((vector_size(16)));
    typedef std::uint64_t Words __attribute__((vector_size(16)));
};
template <>
struct Registers<4> {
    typedef double Doubles __attribute__((vector_size(32)));
    typedef std::uint64_t Words __attribute__((vector_size(32)));
};
template <>
struct Registers<8> {
    typedef double Doubles __attribute__((vector_size(64)));
    typedef std::uint64_t Words __attribute__((vector_size(64)));
};

/// Returns the largest of `vector_widths` that this processor has.
std::size_t widest_vector_width();

/// Returns the width in use. It is the widest, unless a test or a benchmark has set another.
std::size_t vector_width();
/// Sets the width in use. Throws std::invalid_argument if the width is not in `vector_widths`, or if the processor does
/// not have it.
void use_vector_width(std::size_t width);

#ifdef __x86_64__
#define PLACEDPAR_AVX2 gnu::target("avx2")
#define PLACEDPAR_AVX512 gnu::target("avx512f,avx512dq,avx512vl,avx512bw")
#else
#define PLACEDPAR_AVX2 gnu::noinline
#define PLACEDPAR_AVX512 gnu::noinline
#endif

/// in_vectors(work) calls `work.operator()<width>()` for the width in use. The call, with everything inlined into it,
/// is compiled for this width.
template <class Work>
[[gnu::flatten]] void in_vectors_of_2(const Work& work) {
    work.template operator()<2>();
}
template <class Work>
[[gnu::flatten, PLACEDPAR_AVX2]] void in_vectors_of_4(const Work& work) {
    work.template operator()<4>();
}
template <class Work>
[[gnu::flatten, PLACEDPAR_AVX512]] void in_vectors_of_8(const Work& work) {
    work.template operator()<8>();
}
template <class Work>
void in_vectors(const Work& work) {
    switch (vector_width()) {
    case 8: return in_vectors_of_8(work);
    case 4: return in_vectors_of_4(work);
    default: return in_vectors_of_2(work);
    }
}

} // namespace placedpar
