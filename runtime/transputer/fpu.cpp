#include "runtime/transputer/fpu.hpp"

#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace placedpar::transputer {

namespace {

/// The NaNs that operations make, as REAL32s. In a REAL64 zeros follow the fraction. We did not have INMOS's table. The
/// values come from the public emulator pahihu/t4 (fparithmetic.c), whose results a validation suite (TVS1F) compared
/// with the results of a T801. INMOS's library for the T414 confirms the NaNs for 0/0, 0 * infinity and infinity -
/// infinity.
enum class MadeNan : std::uint32_t {
    zero_by_zero = 0x7FC00000,
    infinity_by_infinity = 0x7FA00000,
    zero_times_infinity = 0x7F900000,
    difference_of_infinities = 0x7F880000,
    root_of_negative = 0x7F840000,
    shortened = 0x7F820000, ///< a REAL64 NaN as a REAL32
    remainder_of_infinity = 0x7F804000,
    remainder_by_zero = 0x7F802000,
    quotient_without_remainder = 0x7F801000 ///< left in register FB
};

/// The result of an operation, and whether the operation sets FPError.
template <typename T>
struct RealResult {
    RealPattern<T> pattern;
    bool error = false;
};

/// The function that computes left op right, as an argument of rounded().
struct Arithmetic {
    RealOperation operation;

    template <typename T>
    T operator()(T left, T right) const {
        return computed_on_host(operation, left, right);
    }
};

#ifdef FE_OVERFLOW

/// Sets the rounding mode of the host's processor for the life of this object, and notices overflow.
class HostRounding {
public:
    explicit HostRounding(Rounding mode) {
        static constexpr std::array modes{FE_TONEAREST, FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD};
        std::feclearexcept(FE_OVERFLOW);
        std::fesetround(modes[std::size_t(mode)]);
    }
    ~HostRounding() { std::fesetround(FE_TONEAREST); }
    HostRounding(const HostRounding&) = delete;
    HostRounding& operator=(const HostRounding&) = delete;

    bool overflow() const { return std::fetestexcept(FE_OVERFLOW) != 0; }
};

/// Computes an operation on the host's processor in a rounding mode. In the result, `error` means overflow. The
/// operands and the result are volatile, so that the compiler does not move the operation out of the scope of `host`.
template <typename T, typename Operand, typename Operation>
[[gnu::noinline]] RealResult<T> rounded(Rounding mode, Operand left, Operand right, Operation operation) {
    volatile Operand first = left, second = right;
    const HostRounding host(mode);
    volatile T result = T(operation(Operand(first), Operand(second)));
    const T value = result;
    return {RealPattern<T>::of(value), host.overflow()};
}

#else

// WebAssembly rounds to nearest, and has no flag for overflow. There, a long double has 113 bits of fraction.

/// Returns the rounding error of a sum of long doubles. Returns 0 for other operations, because a long double shows
/// whether their results are longer than a double.
template <typename Operation>
long double rest_of_sum(const Operation&, long double, long double, long double) {
    return 0;
}
inline long double rest_of_sum(const Arithmetic& of, long double left, long double right, long double sum) {
    if (of.operation != RealOperation::add && of.operation != RealOperation::subtract)
        return 0;
    const long double added = of.operation == RealOperation::add ? right : -right, rounded_part = sum - left;
    return (left - (sum - rounded_part)) + (added - rounded_part);
}

/// Returns whether a sum that is exactly zero is -0 in the mode `minus`. It is +0 only if both terms are +0.
template <typename Operation>
bool is_negative_zero(const Operation&, long double, long double) {
    return false;
}
inline bool is_negative_zero(const Arithmetic& of, long double left, long double right) {
    if (of.operation != RealOperation::add && of.operation != RealOperation::subtract)
        return false;
    return std::signbit(left) || std::signbit(right) != (of.operation == RealOperation::subtract);
}

/// Computes an operation in a rounding mode. In the result, `error` means overflow. Begins with the result rounded to
/// nearest. If the mode requires the neighbour of this result, returns the neighbour.
template <typename T, typename Operand, typename Operation>
RealResult<T> rounded(Rounding mode, Operand left, Operand right, Operation operation) {
    const T nearest = T(operation(left, right));
    const long double exact = operation(static_cast<long double>(left), static_cast<long double>(right));
    long double beyond = exact - nearest;
    if (beyond == 0)
        beyond = rest_of_sum(operation, left, right, exact);
    const bool may_fall = mode == Rounding::minus || (mode == Rounding::zero && exact > 0);
    const bool may_rise = mode == Rounding::plus || (mode == Rounding::zero && exact < 0);
    T result = nearest;
    if (beyond < 0 && may_fall)
        result = std::nextafter(nearest, -HUGE_VALF);
    else if (beyond > 0 && may_rise)
        result = std::nextafter(nearest, HUGE_VALF);
    else if (exact == 0 && mode == Rounding::minus && is_negative_zero(operation, left, right))
        result = -T{0};
    const long double limit = std::ldexp(1.0L, std::numeric_limits<T>::max_exponent);
    return {RealPattern<T>::of(result), std::isfinite(exact) && (std::isinf(result) || std::abs(exact) >= limit)};
}

#endif

/// Converts a REAL32 NaN or infinity to another length, with the same sign and the same first bits of the fraction.
template <typename T>
RealPattern<T> widened(std::uint32_t bits) {
    const RealPattern<float> narrow(bits);
    constexpr int shift = RealPattern<T>::fraction_bits - RealPattern<float>::fraction_bits;
    return RealPattern<T>(RealPattern<T>::exponent_mask | typename RealPattern<T>::Word(narrow.fraction()) << shift)
        .with_sign(narrow.negative());
}

template <typename T>
RealResult<T> made(MadeNan nan) {
    return {widened<T>(std::uint32_t(nan)), true};
}

/// Returns the NaN that results from two operands, at least one of which is a NaN.
template <typename T>
RealPattern<T> greater_nan(RealPattern<T> left, RealPattern<T> right) {
    return !right.nan() || (left.nan() && left.fraction() >= right.fraction()) ? left : right;
}

/// Calls a function with a float for REAL32, or with a double for REAL64.
template <typename Function>
auto in_type_of(Length length, Function function) {
    return length == Length::real32 ? function(float{}) : function(double{});
}

template <typename T>
constexpr Length length_of = sizeof(T) == 4 ? Length::real32 : Length::real64;

template <typename T>
Real real_of(RealPattern<T> pattern) {
    return {pattern.word(), length_of<T>};
}

/// Returns a finite number rounded to an integer.
template <typename T>
T integer(T value, Rounding mode) {
    switch (mode) {
    case Rounding::nearest: return std::rint(value);
    case Rounding::zero: return std::trunc(value);
    case Rounding::plus: return std::ceil(value);
    case Rounding::minus: return std::floor(value);
    }
    return value;
}

/// Returns the integer part of a finite number, rounded down, modulo 2^32.
std::uint32_t low_word(double value) {
    const double whole = std::fmod(std::floor(value), 0x1p32);
    return std::uint32_t(std::int64_t(whole));
}

/// Returns a finite REAL64 as a REAL32.
RealResult<float> shortened(double value, Rounding mode) {
    if (mode == Rounding::nearest) {
        const auto result = RealPattern<float>::of(float(value));
        return {result, result.infinite()};
    }
    return rounded<float>(mode, value, value, [](auto each, auto) { return each; });
}

template <typename T>
RealResult<T> root(RealPattern<T> of, Rounding mode) {
    if (of.nan() || of.zero())
        return {of, of.nan()};
    if (of.negative())
        return made<T>(MadeNan::root_of_negative);
    if (of.infinite())
        return {of, true};
    if (mode == Rounding::nearest)
        return {RealPattern<T>::of(std::sqrt(of.value()))};
    return rounded<T>(mode, of.value(), of.value(), [](auto each, auto) { return std::sqrt(each); });
}

/// Returns the exact remainder of left divided by right.
template <typename T>
RealResult<T> remainder(RealPattern<T> left, RealPattern<T> right) {
    if (left.nan() || right.nan())
        return {greater_nan(left, right), true};
    if (left.infinite())
        return made<T>(MadeNan::remainder_of_infinity);
    if (right.zero())
        return made<T>(MadeNan::remainder_by_zero);
    const auto exact = RealPattern<T>::of(std::remainder(left.value(), right.value()));
    // GNU's library gives a zero of the wrong sign if the divisor is the least denormal
    return {exact.zero() ? exact.with_sign(left.negative()) : exact, right.infinite()};
}

/// Returns the quotient that belongs to a remainder. The quotient is computed in double, and then rounded to an
/// integer. Before the rounding its error is below 0.5 for all operands that the instruction fpremfirst accepts.
template <typename T>
RealPattern<T> quotient(RealPattern<T> left, RealPattern<T> right, RealPattern<T> remainder) {
    if (remainder.nan())
        return made<T>(MadeNan::quotient_without_remainder).pattern;
    const double divisor = right.value();
    const double whole = std::rint(double(left.value()) / divisor - double(remainder.value()) / divisor);
    return RealPattern<T>::of(T(whole)).with_sign(left.negative() != right.negative());
}

template <typename T>
RealPattern<T> signed_nan(RealOperation operation, RealPattern<T> left, RealPattern<T> right) {
    const RealPattern<T> nan = greater_nan(left, right);
    switch (operation) {
    case RealOperation::add: return nan;
    case RealOperation::subtract: return nan.word() == left.word() ? nan : nan.negated();
    case RealOperation::multiply:
    case RealOperation::divide: return nan.with_sign(left.negative() != right.negative());
    }
    return nan;
}

template <typename T>
std::optional<MadeNan> invalid(RealOperation operation, RealPattern<T> left, RealPattern<T> right) {
    const bool infinities = left.infinite() && right.infinite();
    const bool equal_signs = left.negative() == right.negative();
    if (operation == RealOperation::add && infinities && !equal_signs)
        return MadeNan::difference_of_infinities;
    if (operation == RealOperation::subtract && infinities && equal_signs)
        return MadeNan::difference_of_infinities;
    if (operation == RealOperation::multiply &&
        ((left.zero() && right.infinite()) || (left.infinite() && right.zero())))
        return MadeNan::zero_times_infinity;
    if (operation == RealOperation::divide && left.zero() && right.zero())
        return MadeNan::zero_by_zero;
    if (operation == RealOperation::divide && infinities)
        return MadeNan::infinity_by_infinity;
    return std::nullopt;
}

template <typename T>
RealResult<T> combined(RealOperation operation, Rounding mode, RealPattern<T> left, RealPattern<T> right) {
    if (left.nan() || right.nan())
        return {signed_nan(operation, left, right), true};
    if (auto nan = invalid(operation, left, right))
        return made<T>(*nan);
    const auto computed = rounded<T>(mode, left.value(), right.value(), Arithmetic{operation});
    const bool error = !left.finite() || !right.finite() || (operation == RealOperation::divide && right.zero());
    return {computed.pattern, computed.error || error};
}

using Single = RealPattern<float>;

/// Returns the value of a finite REAL32. After fpunoround, its fraction is as long as the fraction of a REAL64.
double value_with_whole_fraction(const Real& real) {
    const RealPattern<double> wide = RealPattern<double>::of(Single(real.bits).value());
    return RealPattern<double>(wide.word() | (real.bits >> 32)).value();
}

/// Returns the result of the operation on REAL32s with long fractions (fpunoround), rounded once to a REAL32. If the
/// result were rounded to nearest twice, it could be wrong. The intermediate REAL64 is therefore rounded to odd: its
/// last bit is set if the REAL64 is not exact.
RealResult<float> combined_unrounded(RealOperation operation, Rounding mode, const Real& left, const Real& right) {
    const double first = value_with_whole_fraction(left), second = value_with_whole_fraction(right);
    const auto compute = [&](Rounding each) { return rounded<double>(each, first, second, Arithmetic{operation}); };
    const auto cut = compute(Rounding::zero), up = compute(Rounding::plus), down = compute(Rounding::minus);
    const bool is_exact = up.pattern.word() == down.pattern.word();
    const RealPattern<double> odd(cut.pattern.word() | std::uint64_t(!is_exact));
    auto result = shortened(odd.value(), mode);
    result.error |= operation == RealOperation::divide && second == 0;
    return result;
}

} // namespace

void Fpu::combine_by_rules(RealOperation operation, const Real& left, const Real& right) {
    in_type_of(right.length, [&](auto type) {
        using T = decltype(type);
        auto result = combined(operation, rounding_, RealPattern<T>(left.bits), RealPattern<T>(right.bits));
        if constexpr (sizeof(T) == 4) {
            const bool is_longer = (left.bits | right.bits) >> 32 != 0; // a fraction after fpunoround
            if (is_longer && Single(left.bits).finite() && Single(right.bits).finite())
                result = combined_unrounded(operation, rounding_, left, right);
        }
        a_ = real_of(result.pattern);
        error_ |= result.error;
    });
    rounding_ = Rounding::nearest;
}

/// Multiplies FA by the factor, which is a power of 2.
void Fpu::scale(float factor) {
    const Real by = in_type_of(a_.length, [&](auto type) { return real_of(RealPattern<decltype(type)>::of(factor)); });
    combine(RealOperation::multiply, a_, by);
}

std::uint32_t Fpu::fpstnli32() {
    const Real top = pop();
    return in_type_of(top.length, [&](auto type) {
        const RealPattern<decltype(type)> pattern(top.bits);
        return pattern.finite() ? low_word(pattern.value()) : 0;
    });
}

bool Fpu::fpremfirst() {
    in_type_of(a_.length, [&](auto type) {
        using T = decltype(type);
        const RealPattern<T> left(b_.bits), right(a_.bits);
        const auto result = remainder(left, right);
        a_ = real_of(result.pattern);
        b_ = real_of(quotient(left, right, result.pattern));
        error_ |= result.error;
    });
    return finished(true);
}

bool Fpu::fpgt() {
    const bool greater = in_type_of(a_.length, [&](auto type) {
        const RealPattern<decltype(type)> left(b_.bits), right(a_.bits);
        error_ |= !left.finite() || !right.finite();
        return left.value() > right.value();
    });
    pop();
    pop();
    return greater;
}

bool Fpu::fpeq() {
    const bool equal = in_type_of(a_.length, [&](auto type) {
        const RealPattern<decltype(type)> left(b_.bits), right(a_.bits);
        error_ |= !left.finite() || !right.finite();
        return left.value() == right.value();
    });
    pop();
    pop();
    return equal;
}

bool Fpu::fpordered() {
    return finished(in_type_of(a_.length, [&](auto type) {
        return !RealPattern<decltype(type)>(b_.bits).nan() && !RealPattern<decltype(type)>(a_.bits).nan();
    }));
}

bool Fpu::fpnan() {
    return finished(in_type_of(a_.length, [&](auto type) { return RealPattern<decltype(type)>(a_.bits).nan(); }));
}

bool Fpu::fpnotfinite() {
    return finished(in_type_of(a_.length, [&](auto type) { return !RealPattern<decltype(type)>(a_.bits).finite(); }));
}

bool Fpu::fptesterror() {
    const bool clear = !error_;
    set_error(false);
    return clear;
}

void Fpu::set_error(bool error) {
    error_ = error;
    rounding_ = Rounding::nearest;
}

void Fpu::fpi32tor32(std::uint32_t word) { push(real_of(shortened(std::int32_t(word), rounding_).pattern)); }

void Fpu::fpint() {
    in_type_of(a_.length, [&](auto type) {
        const RealPattern<decltype(type)> pattern(a_.bits);
        if (pattern.finite())
            a_ = real_of(RealPattern<decltype(type)>::of(integer(pattern.value(), rounding_)));
        else
            error_ = true;
    });
    rounding_ = Rounding::nearest;
}

void Fpu::fprtoi32() {
    fpint();
    fpuchki32();
}

void Fpu::check_below(double limit) {
    in_type_of(a_.length, [&](auto type) {
        const double value = RealPattern<decltype(type)>(a_.bits).value();
        error_ |= !(-limit <= value && value < limit); // true for a NaN
    });
    rounding_ = Rounding::nearest;
}

void Fpu::fpur32tor64() {
    const RealPattern<float> narrow(a_.bits);
    a_ = real_of(narrow.finite() ? RealPattern<double>::of(narrow.value()) : widened<double>(narrow.word()));
    error_ |= !narrow.finite();
    rounding_ = Rounding::nearest;
}

void Fpu::fpur64tor32() {
    const RealPattern<double> wide(a_.bits);
    const auto result = wide.nan() ? made<float>(MadeNan::shortened) : shortened(wide.value(), rounding_);
    a_ = real_of(result.pattern);
    error_ |= result.error || !wide.finite();
    rounding_ = Rounding::nearest;
}

void Fpu::fpunoround() {
    const RealPattern<double> wide(a_.bits);
    const std::uint64_t exponent = (wide.word() & wide.exponent_mask) >> wide.fraction_bits;
    const std::uint32_t lower = exponent == 0 ? 0 : std::uint32_t(exponent - 1023 + 127) & 0xFF;
    const RealPattern<float> narrow(lower << 23 | std::uint32_t(wide.fraction() >> 29));
    a_ = real_of(narrow.with_sign(wide.negative()));
    if (lower != 0 && lower != 0xFF)
        a_.bits |= (wide.fraction() & 0x1FFF'FFFF) << 32;
    rounding_ = Rounding::nearest;
}

void Fpu::fpuabs() {
    in_type_of(a_.length, [&](auto type) {
        const auto absolute = RealPattern<decltype(type)>(a_.bits).absolute();
        a_ = real_of(absolute);
        error_ |= !absolute.finite();
    });
    rounding_ = Rounding::nearest;
}

void Fpu::fpusqrtfirst() {
    in_type_of(a_.length, [&](auto type) {
        const auto result = root(RealPattern<decltype(type)>(a_.bits), rounding_);
        a_ = real_of(result.pattern);
        error_ |= result.error;
    });
    rounding_ = Rounding::nearest;
}

} // namespace placedpar::transputer
