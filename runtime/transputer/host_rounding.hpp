#pragma once

#include "runtime/transputer/fpu.hpp"
#include "runtime/transputer/real_pattern.hpp"

#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <limits>

namespace placedpar::transputer {

/// A result before it is in a register.
template <typename T>
struct RealResult {
    RealPattern<T> pattern;
    bool error = false;
};

/// left op right, for rounded().
struct Arithmetic {
    RealOperation operation;

    template <typename T>
    T operator()(T left, T right) const {
        return computed_on_host(operation, left, right);
    }
};

#ifdef FE_OVERFLOW

/// Sets the host's rounding mode for the life of this object, and notices overflow.
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

/// Returns an operation's result on the host in a rounding mode; error means overflow. Compilers do not know that the
/// mode matters: volatile operands and results keep the operation between the two changes of the mode.
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

/// Returns what a sum lacks that was rounded to a long double; 0 for other operations. Their results are longer than a
/// double wherever they differ from it.
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

/// Returns the sign of a sum that is exactly zero, in the mode `minus`: it is negative unless both terms are +0.
template <typename Operation>
bool is_negative_zero(const Operation&, long double, long double) {
    return false;
}
inline bool is_negative_zero(const Arithmetic& of, long double left, long double right) {
    if (of.operation != RealOperation::add && of.operation != RealOperation::subtract)
        return false;
    return std::signbit(left) || std::signbit(right) != (of.operation == RealOperation::subtract);
}

/// Returns an operation's result in a rounding mode; error means overflow. Moves the result nearest to the exact one to
/// its neighbour if the exact result is on the other side.
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

} // namespace placedpar::transputer
