// Compares the floating-point unit with exact arithmetic: all pairs of special values, and random ones.

#include "runtime/transputer/fpu.hpp"

#include "tests/runtime/transputer/exact_reals.hpp"
#include "tests/runtime/transputer/real_values.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <cfenv>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using namespace placedpar::transputer;

namespace {

using Operation = void (Fpu::*)();

struct Binary {
    const char* name;
    Operation run;
    ExactOperation exact;
};

constexpr std::array four{
    Binary{"fpadd", &Fpu::fpadd, ExactOperation::add}, Binary{"fpsub", &Fpu::fpsub, ExactOperation::subtract},
    Binary{"fpmul", &Fpu::fpmul, ExactOperation::multiply}, Binary{"fpdiv", &Fpu::fpdiv, ExactOperation::divide}};

bool nan(Real real) {
    return real.length == Length::real32 ? RealPattern<float>(real.bits).nan() : RealPattern<double>(real.bits).nan();
}

bool finite(Real real) {
    return real.length == Length::real32 ? RealPattern<float>(real.bits).finite()
                                         : RealPattern<double>(real.bits).finite();
}

bool negative(Real real) { return real.bits >> (real.length == Length::real32 ? 31 : 63) != 0; }
bool zero(Real real) { return finite(real) && exactly_compared(real, {0, real.length}) == 0; }

void set_mode(Fpu& unit, Rounding mode) {
    static constexpr std::array set{&Fpu::fpurn, &Fpu::fpurz, &Fpu::fpurp, &Fpu::fpurm};
    (unit.*set[std::size_t(mode)])();
}

void load(Fpu& unit, Real real) {
    if (real.length == Length::real32)
        unit.fpldnlsn(std::uint32_t(real.bits));
    else
        unit.fpldnldb(real.bits);
}

/// Returns a unit with three numbers on its stack, the last in FA, and a mode.
Fpu loaded(Real c, Real b, Real a, Rounding mode) {
    Fpu unit;
    for (Real each : {c, b, a})
        load(unit, each);
    set_mode(unit, mode);
    return unit;
}

struct Expected {
    Real real;
    bool error = false;
};

std::string shown(Real real) { return fmt::format("#{:0{}X}", real.bits, real.length == Length::real32 ? 8 : 16); }

/// Compares FA, FPError, the mode and the host's mode; fails with a sentence.
void require(const Fpu& unit, Expected expected, const char* name, Rounding mode, Real left, Real right) {
    if (unit.fa() == expected.real && unit.error() == expected.error && unit.rounding() == Rounding::nearest &&
        std::fegetround() == FE_TONEAREST)
        return;
    FAIL_CHECK(fmt::format("{} in mode {} of {} and {} gives {}, FPError {}; it should be {}, FPError {}", name,
                           int(mode), shown(left), shown(right), shown(unit.fa()), unit.error(), shown(expected.real),
                           expected.error));
}

/// Returns a NaN's pattern as the databook prints it, for a REAL32, in a length.
Real made_nan(std::uint32_t pattern, Length length) {
    if (length == Length::real32)
        return {pattern, length};
    return {0x7FF0'0000'0000'0000 | std::uint64_t(pattern & 0x7F'FFFF) << 29, length};
}

std::uint64_t fraction(Real real) {
    return real.bits & (real.length == Length::real32 ? 0x7F'FFFFU : 0xF'FFFF'FFFF'FFFFU);
}

Real opposite(Real real) {
    return {real.bits ^ (real.length == Length::real32 ? 1ULL << 31 : 1ULL << 63), real.length};
}

/// Returns what two operands give, one of which is a NaN.
Real expected_nan(ExactOperation operation, Real left, Real right) {
    const bool from_left = !nan(right) || (nan(left) && fraction(left) >= fraction(right));
    const Real chosen = from_left ? left : right;
    if (operation == ExactOperation::subtract && !from_left)
        return opposite(chosen);
    const bool product = operation == ExactOperation::multiply || operation == ExactOperation::divide;
    const bool minus = negative(left) != negative(right);
    return product && negative(chosen) != minus ? opposite(chosen) : chosen;
}

/// Returns the pattern of an invalid operation.
std::uint32_t invalid_pattern(ExactOperation operation, Real left) {
    switch (operation) {
    case ExactOperation::divide: return finite(left) ? 0x7FC00000 : 0x7FA00000;
    case ExactOperation::multiply: return 0x7F900000;
    case ExactOperation::remainder: return finite(left) ? 0x7F802000 : 0x7F804000;
    case ExactOperation::root: return 0x7F840000;
    default: return 0x7F880000;
    }
}

Expected expected(ExactOperation operation, Rounding mode, Real left, Real right) {
    if (nan(left) || nan(right))
        return {expected_nan(operation, left, right), true};
    const ExactReal result = exact(operation, mode, right.length, left, right);
    if (nan(result.real))
        return {made_nan(invalid_pattern(operation, left), right.length), true};
    const bool by_zero = operation == ExactOperation::divide && zero(right);
    return {result.real, result.overflow || by_zero || !finite(left) || !finite(right)};
}

void compare_four(Real left, Real right) {
    const Real below{42, left.length};
    for (Rounding mode : all_modes)
        for (const Binary& each : four) {
            Fpu unit = loaded(below, left, right, mode);
            (unit.*each.run)();
            require(unit, expected(each.exact, mode, left, right), each.name, mode, left, right);
            if (unit.fb() != below)
                FAIL_CHECK(fmt::format("{} leaves {} in FB", each.name, shown(unit.fb())));
        }
}

void compare_remainder(Real left, Real right) {
    for (Rounding mode : all_modes) {
        Fpu unit = loaded({}, left, right, mode);
        CHECK_EQ(unit.fpremfirst(), true);
        require(unit, expected(ExactOperation::remainder, Rounding::nearest, left, right), "fpremfirst", mode, left,
                right);
    }
}

struct Unary {
    const char* name;
    Operation run;
    std::function<ExactReal(Rounding, Real)> exact;
};

ExactReal by_exact(ExactOperation operation, Rounding mode, Real operand) {
    return exact(operation, mode, operand.length, operand, operand);
}

const std::vector<Unary>& unary_operations() {
    static const std::vector<Unary> all{
        {"fpusqrtfirst", &Fpu::fpusqrtfirst, [](auto mode, Real a) { return by_exact(ExactOperation::root, mode, a); }},
        {"fpint", &Fpu::fpint, [](auto mode, Real a) { return by_exact(ExactOperation::integer, mode, a); }},
        {"fpuabs", &Fpu::fpuabs, [](auto, Real a) { return ExactReal{negative(a) ? opposite(a) : a}; }},
        {"fpumulby2", &Fpu::fpumulby2, [](auto mode, Real a) { return exactly_scaled(mode, a, 1); }},
        {"fpudivby2", &Fpu::fpudivby2, [](auto mode, Real a) { return exactly_scaled(mode, a, -1); }},
        {"fpuexpinc32", &Fpu::fpuexpinc32, [](auto mode, Real a) { return exactly_scaled(mode, a, 32); }},
        {"fpuexpdec32", &Fpu::fpuexpdec32, [](auto mode, Real a) { return exactly_scaled(mode, a, -32); }},
    };
    return all;
}

Expected expected(const Unary& operation, Rounding mode, Real operand) {
    if (nan(operand))
        return {operation.run == &Fpu::fpuabs && negative(operand) ? opposite(operand) : operand, true};
    const ExactReal result = operation.exact(mode, operand);
    if (nan(result.real))
        return {made_nan(invalid_pattern(ExactOperation::root, operand), operand.length), true};
    return {result.real, result.overflow || !finite(operand)};
}

/// fprtoi32 rounds as fpint, and then the range is that of 32 bits.
void compare_to_integer(Rounding mode, Real operand) {
    Expected integer = expected(unary_operations()[1], mode, operand);
    integer.error = integer.error || !exactly_within(integer.real, 31);
    Fpu unit = loaded({}, {}, operand, mode);
    unit.fprtoi32();
    require(unit, integer, "fprtoi32", mode, operand, operand);
}

void compare_to_other_length(Rounding mode, Real operand) {
    const bool shortened = operand.length == Length::real64;
    const Length length = shortened ? Length::real32 : Length::real64;
    const ExactReal result = exact(ExactOperation::converted, mode, length, operand, operand);
    Expected other{result.real, result.overflow || !finite(operand)};
    if (nan(operand))
        other.real = shortened           ? made_nan(0x7F820000, length)
                     : negative(operand) ? opposite(made_nan(std::uint32_t(fraction(operand)), length))
                                         : made_nan(std::uint32_t(fraction(operand)), length);
    Fpu unit = loaded({}, {}, operand, mode);
    shortened ? unit.fpur64tor32() : unit.fpur32tor64();
    require(unit, other, shortened ? "fpur64tor32" : "fpur32tor64", mode, operand, operand);
}

void compare_checks(Real operand) {
    for (auto [bits, check] : {std::pair{31, &Fpu::fpuchki32}, std::pair{63, &Fpu::fpuchki64}}) {
        Fpu unit = loaded({}, {}, operand, Rounding::minus);
        (unit.*check)();
        const bool error = nan(operand) || !exactly_within(operand, bits);
        require(unit, {operand, error}, "fpuchki", Rounding::minus, operand, operand);
    }
}

void compare_unary(Real operand) {
    for (Rounding mode : all_modes) {
        for (const Unary& each : unary_operations()) {
            Fpu unit = loaded({}, {}, operand, mode);
            (unit.*each.run)();
            require(unit, expected(each, mode, operand), each.name, mode, operand, operand);
        }
        compare_to_integer(mode, operand);
        compare_to_other_length(mode, operand);
    }
    compare_checks(operand);
    Fpu unit = loaded({}, {}, operand, Rounding::plus);
    CHECK_EQ(unit.fpstnli32(), finite(operand) ? exact_low_word(operand) : 0);
    CHECK_EQ(unit.error(), false);
}

void compare_comparisons(Real left, Real right) {
    const bool ordered = !nan(left) && !nan(right), error = !finite(left) || !finite(right);
    const int order = ordered ? exactly_compared(left, right) : 0;
    Fpu greater = loaded({42, left.length}, left, right, Rounding::plus), equal = greater, tested = greater;
    const bool right_answers = greater.fpgt() == (ordered && order > 0) && equal.fpeq() == (ordered && order == 0) &&
                               tested.fpordered() == ordered && tested.fa() == right && tested.fb() == left;
    if (!right_answers || greater.error() != error || equal.error() != error || tested.error() ||
        greater.fa().bits != 42 || equal.fa().bits != 42)
        FAIL_CHECK(fmt::format("{} and {} are compared wrongly", shown(left), shown(right)));
}

} // namespace

TEST_CASE("the unit computes all pairs of special values as exact arithmetic does") {
    for (Length length : all_lengths)
        for (Real left : special_reals(length))
            for (Real right : special_reals(length)) {
                compare_four(left, right);
                compare_comparisons(left, right);
            }
}

TEST_CASE("the remainder of special values is that of exact arithmetic") {
    for (Length length : all_lengths)
        for (Real left : special_reals(length))
            for (Real right : special_reals(length))
                compare_remainder(left, right);
}

TEST_CASE("the unit computes random values as exact arithmetic does") {
    for (std::uint64_t seed : seeds(10)) {
        INFO(replay(seed));
        for (Length length : all_lengths) {
            RandomReals random(seed, length);
            for (int i = 0; i < 800; ++i) {
                const Real left = random.finite(), right = random.finite_beside(left);
                compare_four(left, right);
                compare_comparisons(left, right);
                compare_remainder(left, right);
                compare_unary(right);
            }
        }
    }
}

TEST_CASE("the unit converts, scales and rounds special values as exact arithmetic does") {
    for (Length length : all_lengths)
        for (Real operand : special_reals(length)) {
            compare_unary(operand);
            CHECK_EQ(loaded({}, {}, operand, Rounding::zero).fpnan(), nan(operand));
            CHECK_EQ(loaded({}, {}, operand, Rounding::zero).fpnotfinite(), !finite(operand));
        }
}

TEST_CASE("integers become reals as in exact arithmetic") {
    RandomStream random(1, "integers");
    std::vector<std::uint32_t> words{0, 1, 2, 0x7FFFFFFF, 0x80000000, 0x80000001, 0xFFFFFFFF, 0x01000001, 0x01000003};
    for (int i = 0; i < 3'000; ++i)
        words.push_back(random() >> random() % 32);
    for (std::uint32_t word : words)
        for (Rounding mode : all_modes) {
            Fpu unit = loaded({}, {}, {}, mode);
            unit.fpi32tor32(word);
            const Real single = exact_integer(mode, Length::real32, std::int32_t(word)).real;
            require(unit, {single}, "fpi32tor32", mode, {word}, {});
            set_mode(unit, mode);
            unit.fpi32tor64(word);
            const Real signed_real = exact_integer(mode, Length::real64, std::int32_t(word)).real;
            require(unit, {signed_real}, "fpi32tor64", mode, {word}, {});
            set_mode(unit, mode);
            unit.fpb32tor64(word);
            const Real unsigned_real = exact_integer(mode, Length::real64, word).real;
            require(unit, {unsigned_real}, "fpb32tor64", mode, {word}, {});
            if (unit.fb() != signed_real || unit.fc() != single)
                FAIL_CHECK(fmt::format("the integer {} does not push the stack", word));
        }
}

TEST_CASE("the quotient of a remainder is exact up to the published difference of exponents") {
    for (Length length : all_lengths) {
        RandomReals random(7, length);
        const int bits = length == Length::real32 ? 23 : 52, most = length == Length::real32 ? 20 : 30;
        const auto exponent = [&](Real real) {
            return int(real.bits >> bits & (length == Length::real32 ? 255 : 2047));
        };
        int found = 0;
        while (found < 2'000) {
            const Real left = random.finite(), right = random.finite_beside(left);
            if (exponent(right) == 0 || exponent(left) - exponent(right) > most)
                continue;
            ++found;
            Fpu unit = loaded({}, left, right, Rounding::nearest);
            unit.fpremfirst();
            Real quotient = exact_quotient(left, right, unit.fa());
            if (negative(quotient) != (negative(left) != negative(right))) // that of a zero
                quotient = opposite(quotient);
            if (unit.fb() != quotient)
                FAIL_CHECK(fmt::format("the quotient of {} by {} is {}", shown(left), shown(right), shown(unit.fb())));
        }
    }
}
