#pragma once

#include "runtime/vector_width.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace placedpar {

/// Eight doubles, on which each operation works at once. For example, an objective function is evaluated for eight
/// individuals of a population at once. `width` is the number of doubles in a register. Code written for double works
/// for Lanes, too. Each of the eight lanes gets the same bits as a double would, because every operation rounds once.
/// The functions `max` and `min` compare as std::max and std::min do. Create and use Lanes only in the `Work` that is
/// passed to in_vectors(), because only that code is compiled for this width.
template <std::size_t width>
class Lanes {
public:
    static constexpr std::size_t count = 8;

    Lanes() = default;
    /// Puts one number into all lanes.
    [[gnu::always_inline]] Lanes(double all) { // NOLINT: implicit, as from int to double
        each([&](std::size_t i) { put_into_all(all, registers_[i]); });
    }
    [[gnu::always_inline]] Lanes(const std::array<double, count>& numbers) {
        std::memcpy(registers_, numbers.data(), sizeof registers_);
    }
    /// Converts whole numbers. REQUIRES: numbers below 2^52.
    [[gnu::always_inline]] static Lanes
    of_whole_numbers(const typename Registers<width>::Words (&numbers)[count / width]) {
        // The lower bits of the double 2^52 + n are the bits of n.
        Lanes result;
        each([&](std::size_t i) {
            result.registers_[i] = reinterpret_cast<Register>(numbers[i] | 0x4330000000000000) - 0x1p52;
        });
        return result;
    }
    // The copy constructor is not trivial, so that functions pass Lanes in memory. In registers, code compiled for
    // another width would not find them.
    [[gnu::always_inline]] Lanes(const Lanes& other) { *this = other; }
    [[gnu::always_inline]] Lanes& operator=(const Lanes& other) {
        each([&](std::size_t i) { registers_[i] = other.registers_[i]; });
        return *this;
    }

    [[gnu::always_inline]] std::array<double, count> numbers() const {
        const Lanes copy = *this; // lets the lanes stay in registers until here
        std::array<double, count> numbers;
        std::memcpy(numbers.data(), copy.registers_, sizeof registers_);
        return numbers;
    }

    [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b) {
        Lanes result;
        each([&](std::size_t i) { result.registers_[i] = a.registers_[i] + b.registers_[i]; });
        return result;
    }
    [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b) {
        Lanes result;
        each([&](std::size_t i) { result.registers_[i] = a.registers_[i] - b.registers_[i]; });
        return result;
    }
    [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b) {
        Lanes result;
        each([&](std::size_t i) { result.registers_[i] = a.registers_[i] * b.registers_[i]; });
        return result;
    }
    [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b) {
        Lanes result;
        each([&](std::size_t i) { result.registers_[i] = a.registers_[i] / b.registers_[i]; });
        return result;
    }
    [[gnu::always_inline]] Lanes operator-() const {
        Lanes result;
        each([&](std::size_t i) { result.registers_[i] = -registers_[i]; });
        return result;
    }
    [[gnu::always_inline]] Lanes& operator+=(const Lanes& other) { return *this = *this + other; }
    [[gnu::always_inline]] Lanes& operator-=(const Lanes& other) { return *this = *this - other; }
    [[gnu::always_inline]] Lanes& operator*=(const Lanes& other) { return *this = *this * other; }

    [[gnu::always_inline]] friend Lanes max(const Lanes& a, const Lanes& b) {
        Lanes result;
        each([&](std::size_t i) { take_greater(b.registers_[i], a.registers_[i], result.registers_[i]); });
        return result;
    }
    [[gnu::always_inline]] friend Lanes min(const Lanes& a, const Lanes& b) {
        Lanes result;
        each([&](std::size_t i) { take_less(b.registers_[i], a.registers_[i], result.registers_[i]); });
        return result;
    }
    [[gnu::always_inline]] friend Lanes abs(const Lanes& x) {
        Lanes result;
        each([&](std::size_t i) {
            result.registers_[i] =
                reinterpret_cast<Register>(reinterpret_cast<Bits>(x.registers_[i]) & 0x7fffffffffffffff);
        });
        return result;
    }
    [[gnu::always_inline]] friend Lanes sqrt(const Lanes& x) {
        Lanes result;
        each([&](std::size_t i) { take_root(x.registers_[i], result.registers_[i]); });
        return result;
    }

    // These are computed lane by lane, because not every processor has an instruction for them.
    friend Lanes floor(const Lanes& x) {
        return x.one_by_one([](double each) { return std::floor(each); });
    }
    friend Lanes sin(const Lanes& x) {
        return x.one_by_one([](double each) { return std::sin(each); });
    }
    friend Lanes cos(const Lanes& x) {
        return x.one_by_one([](double each) { return std::cos(each); });
    }
    friend Lanes exp(const Lanes& x) {
        return x.one_by_one([](double each) { return std::exp(each); });
    }
    friend Lanes log(const Lanes& x) {
        return x.one_by_one([](double each) { return std::log(each); });
    }

private:
    using Register = typename Registers<width>::Doubles;
    using Bits = typename Registers<width>::Words;

    template <class Do>
    [[gnu::always_inline]] static void each(const Do& do_register) {
        constexpr std::size_t registers = count / width;
        do_register(0);
        if constexpr (registers > 1)
            do_register(1);
        if constexpr (registers > 2)
            do_register(2), do_register(3);
    }
    template <class Function>
    Lanes one_by_one(Function function) const {
        std::array<double, count> results = numbers();
        for (double& result : results)
            result = function(result);
        return Lanes(results);
    }

    // The results are `a > b ? a : b` and `a < b ? a : b`. Where GCC 12 does not choose the best instruction, the code
    // calls the intrinsic of this instruction.
    [[gnu::always_inline]] static void take_greater(const Register& a, const Register& b, Register& result) {
        result = a > b ? a : b;
    }
    [[gnu::always_inline]] static void take_less(const Register& a, const Register& b, Register& result) {
        result = a < b ? a : b;
    }
    static void put_into_all(double all, Register& result) {
        for (std::size_t i = 0; i < width; ++i)
            result[i] = all;
    }
    static void take_root(const Register& x, Register& root) {
        for (std::size_t i = 0; i < width; ++i)
            root[i] = std::sqrt(x[i]);
    }
#ifdef __x86_64__
    [[PLACEDPAR_AVX512]] static void take_greater(const Register& a, const Register& b,
                                                  Register& result) requires(width == 8) {
        result = _mm512_maskz_max_pd(0xff, a, b);
    }
    [[PLACEDPAR_AVX512]] static void take_less(const Register& a, const Register& b,
                                               Register& result) requires(width == 8) {
        result = _mm512_maskz_min_pd(0xff, a, b);
    }
    static void put_into_all(double all, Register& result) requires(width == 2) { result = _mm_set1_pd(all); }
    [[PLACEDPAR_AVX2]] static void put_into_all(double all, Register& result) requires(width == 4) {
        result = _mm256_set1_pd(all);
    }
    [[PLACEDPAR_AVX512]] static void put_into_all(double all, Register& result) requires(width == 8) {
        result = _mm512_set1_pd(all);
    }
    static void take_root(const Register& x, Register& root) requires(width == 2) { root = _mm_sqrt_pd(x); }
    [[PLACEDPAR_AVX2]] static void take_root(const Register& x, Register& root) requires(width == 4) {
        root = _mm256_sqrt_pd(x);
    }
    [[PLACEDPAR_AVX512]] static void take_root(const Register& x, Register& root) requires(width == 8) {
        root = _mm512_maskz_sqrt_pd(0xff, x);
    }
#endif

    // The alignment is explicit. For widths that the target lacks, GCC aligns registers to 16 bytes, but code for a
    // target with this width expects more.
    alignas(sizeof(double) * width) Register registers_[count / width];
};

} // namespace placedpar
