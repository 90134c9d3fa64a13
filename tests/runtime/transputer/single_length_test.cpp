// Tests the T414's instructions for REAL32 arithmetic: each alone, and as the parts of a library whose results must be
// those of exact arithmetic.

#include "runtime/transputer/single_length.hpp"

#include "tests/runtime/transputer/exact_reals.hpp"
#include "tests/runtime/transputer/real_values.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

using namespace placedpar;
using namespace placedpar::test;
using namespace placedpar::transputer;

namespace {

constexpr std::uint32_t sign_bit = 0x80000000, single_infinity = 0x7F800000;

/// B:A is shifted left until its top bit is set; C := the places, 64 for 0.
SingleLengthRegisters norm(std::uint64_t double_word) {
    const int places = std::countl_zero(double_word);
    const std::uint64_t shifted = places == 64 ? 0 : double_word << places;
    return {std::uint32_t(shifted), std::uint32_t(shifted >> 32), std::uint32_t(places)};
}

/// Returns the REAL32 of a fraction whose bit 63 stands for 1, and of an exponent.
std::uint32_t packed_real(std::uint64_t fraction, std::int32_t exponent) {
    return roundsn(postnormsn(norm(fraction), std::uint32_t(exponent))).a;
}

struct Unpacked {
    std::uint32_t fraction;
    std::int32_t exponent;
    bool zero;
};

Unpacked unpacked_real(std::uint32_t real) {
    const SingleLengthRegisters registers = unpacksn({real, 0, 0});
    return {registers.a, std::int32_t(registers.b), registers.c == std::uint32_t(SingleLengthClass::zero)};
}

std::uint32_t library_product(std::uint32_t left, std::uint32_t right) {
    const std::uint32_t sign = (left ^ right) & sign_bit;
    const Unpacked x = unpacked_real(left), y = unpacked_real(right);
    if (x.zero || y.zero)
        return sign;
    return sign | packed_real(std::uint64_t(x.fraction) * y.fraction, x.exponent + y.exponent - 126); // lmul
}

/// Returns left / right. REQUIRES: right is not 0.
std::uint32_t library_quotient(std::uint32_t left, std::uint32_t right) {
    const std::uint32_t sign = (left ^ right) & sign_bit;
    const Unpacked x = unpacked_real(left), y = unpacked_real(right);
    if (x.zero)
        return sign;
    const auto dividend = norm(std::uint64_t(x.fraction) << 32), divisor = norm(std::uint64_t(y.fraction) << 32);
    const std::int32_t exponent = x.exponent - y.exponent + 127 - std::int32_t(dividend.c) + std::int32_t(divisor.c);
    const std::uint64_t half = std::uint64_t(dividend.b) << 31; // ldiv
    return sign | packed_real(half / divisor.b << 32 | half % divisor.b, exponent);
}

/// Returns a fraction shifted right; if bits are lost, the lowest is 1.
std::uint64_t shifted_right(std::uint64_t fraction, std::int32_t places) {
    if (places >= 64)
        return fraction != 0;
    const std::uint64_t shifted = fraction >> places;
    return shifted << places == fraction ? shifted : shifted | 1;
}

std::uint32_t library_sum(std::uint32_t left, std::uint32_t right) {
    if ((left & ~sign_bit) < (right & ~sign_bit))
        std::swap(left, right);
    const Unpacked x = unpacked_real(left), y = unpacked_real(right);
    const std::uint64_t greater = std::uint64_t(x.fraction) << 32;
    const std::uint64_t smaller = shifted_right(std::uint64_t(y.fraction) << 32, x.exponent - y.exponent);
    if (((left ^ right) & sign_bit) != 0)
        return greater == smaller ? 0 : (left & sign_bit) | packed_real(greater - smaller, x.exponent);
    if (x.zero)
        return left;
    const std::uint64_t sum = greater + smaller;
    if (sum < greater) // carried out
        return (left & sign_bit) | packed_real(shifted_right(sum, 1) | std::uint64_t(1) << 63, x.exponent + 1);
    return (left & sign_bit) | packed_real(sum, x.exponent);
}

void compare_with_exact(const char* name, std::uint32_t result, ExactOperation operation, std::uint32_t left,
                        std::uint32_t right) {
    const auto expected =
        exact(operation, Rounding::nearest, Length::real32, {left, Length::real32}, {right, Length::real32});
    if (result != expected.real.bits)
        FAIL_CHECK(fmt::format("the library's {} of #{:08X} and #{:08X} gives #{:08X}; it should be #{:08X}", name,
                               left, right, result, expected.real.bits));
}

void compare_library(std::uint32_t left, std::uint32_t right) {
    compare_with_exact("sum", library_sum(left, right), ExactOperation::add, left, right);
    compare_with_exact("product", library_product(left, right), ExactOperation::multiply, left, right);
    if ((right & ~sign_bit) != 0)
        compare_with_exact("quotient", library_quotient(left, right), ExactOperation::divide, left, right);
}

} // namespace

TEST_CASE("a library of the T414's instructions computes special values as exact arithmetic does") {
    for (Real left : special_reals(Length::real32))
        for (Real right : special_reals(Length::real32))
            if (!cflerr({std::uint32_t(left.bits), 0, 0}) && !cflerr({std::uint32_t(right.bits), 0, 0}))
                compare_library(std::uint32_t(left.bits), std::uint32_t(right.bits));
}

TEST_CASE("a library of the T414's instructions computes random values as exact arithmetic does") {
    for (std::uint64_t seed : seeds(10)) {
        INFO(replay(seed));
        RandomReals random(seed, Length::real32);
        for (int i = 0; i < 8'000; ++i) {
            const Real left = random.finite(), right = random.finite_beside(left);
            compare_library(std::uint32_t(left.bits), std::uint32_t(right.bits));
        }
    }
}

TEST_CASE("unpacksn gives fraction, exponent and class, and keeps the old B above the class") {
    CHECK_EQ(unpacksn({0xC0490FDB, 5, 9}), SingleLengthRegisters{0xC90FDB00, 128, 21});
    CHECK_EQ(unpacksn({0x80000000, 1, 9}), SingleLengthRegisters{0, 0, 4});
    CHECK_EQ(unpacksn({0x00000001, 0, 9}), SingleLengthRegisters{0x100, 1, 1});
    CHECK_EQ(unpacksn({0x807FFFFF, 0xFFFFFFFF, 9}), SingleLengthRegisters{0x7FFFFF00, 1, 0xFFFFFFFD});
    CHECK_EQ(unpacksn({single_infinity | sign_bit, 2, 9}), SingleLengthRegisters{0, 255, 10});
    CHECK_EQ(unpacksn({0x7FC00000, 3, 9}), SingleLengthRegisters{0x40000000, 255, 15});
}

TEST_CASE("postnormsn limits exponents, makes denormals and keeps lost bits") {
    CHECK_EQ(postnormsn({1, sign_bit, 3}, 130), SingleLengthRegisters{1, sign_bit, 127});
    CHECK_EQ(postnormsn({1, sign_bit, 3}, 258), SingleLengthRegisters{1, sign_bit, 255});
    CHECK_EQ(postnormsn({1, sign_bit, 3}, 259), SingleLengthRegisters{1, sign_bit, 255});
    CHECK_EQ(postnormsn({0, sign_bit | 1, 0}, 0), SingleLengthRegisters{sign_bit, 0x40000000, 0});
    CHECK_EQ(postnormsn({1, sign_bit, 1}, 0), SingleLengthRegisters{1, 0x20000000, 0});
    CHECK_EQ(postnormsn({1, sign_bit, 0}, std::uint32_t(-31)), SingleLengthRegisters{sign_bit | 1, 0, 0});
    CHECK_EQ(postnormsn({1, sign_bit, 0}, std::uint32_t(-32)), SingleLengthRegisters{0, 0, 0});
}

TEST_CASE("roundsn rounds ties to even and gives infinity from exponent 255") {
    CHECK_EQ(roundsn({0, 0x80000080, 127}).a, 0x3F800000);
    CHECK_EQ(roundsn({1, 0x80000080, 127}).a, 0x3F800001);
    CHECK_EQ(roundsn({0, 0x80000081, 127}).a, 0x3F800001);
    CHECK_EQ(roundsn({0, 0x80000180, 127}), SingleLengthRegisters{0x3F800002, 0x3F800002, 0});
    CHECK_EQ(roundsn({1, 0x8000007F, 127}).a, 0x3F800000);
    CHECK_EQ(roundsn({0, 0xFFFFFFFF, 254}).a, single_infinity);
    CHECK_EQ(roundsn({5, 0x80000300, 255}), SingleLengthRegisters{single_infinity, 0x80000300, 0x600});
}

TEST_CASE("ldinf pushes infinity, and cflerr finds it and NaNs") {
    CHECK_EQ(ldinf({1, 2, 3}), SingleLengthRegisters{single_infinity, 1, 2});
    for (Real each : special_reals(Length::real32)) {
        const auto bits = std::uint32_t(each.bits);
        CHECK_EQ(cflerr({bits, single_infinity, single_infinity}), (bits & single_infinity) == single_infinity);
    }
}
