#include "occam/check/constant.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

namespace placedpar::occam {

namespace {

constexpr Folded overflow = {0, "overflows"};
constexpr Folded division_by_zero = {0, "divides by zero"};
constexpr Folded not_finite = {0, "does not give a finite number"};

unsigned width_of(Basic basic) { return 8 * bytes_of(basic); }

/// Returns the value of this type whose bits are the lowest bits of `bits`.
std::int64_t wrapped(Basic basic, std::uint64_t bits) {
    switch (basic) {
    case Basic::byte: return static_cast<std::uint8_t>(bits);
    case Basic::int16: return static_cast<std::int16_t>(bits);
    case Basic::int64:
    case Basic::real64: return static_cast<std::int64_t>(bits);
    case Basic::boolean: return static_cast<std::int64_t>(bits & 1);
    case Basic::real32: return static_cast<std::uint32_t>(bits);
    default: return static_cast<std::int32_t>(bits);
    }
}

/// Returns the bits of a value without its sign extension.
std::uint64_t pattern(Basic basic, std::int64_t bits) {
    const unsigned width = width_of(basic);
    return static_cast<std::uint64_t>(bits) & (width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1);
}

/// Returns the result of an operation that was computed in 64 bits. If this computation overflowed, or if the type
/// cannot hold the result, returns an error.
Folded fitting(Basic basic, std::int64_t value, bool overflowed) {
    return overflowed || wrapped(basic, static_cast<std::uint64_t>(value)) != value ? overflow : Folded{value};
}

Folded fold_shift(Operator operation, Basic basic, std::int64_t left, std::int64_t count) {
    if (count < 0 || count > width_of(basic))
        return {0, "shifts by a count out of range"};
    if (count == 64)
        return {0};
    const std::uint64_t bits = pattern(basic, left);
    return {wrapped(basic, operation == Operator::shift_left ? bits << count : bits >> count)};
}

Folded fold_division(Operator operation, Basic basic, std::int64_t left, std::int64_t right) {
    if (right == 0)
        return division_by_zero;
    if (right == -1)
        return operation == Operator::remainder ? Folded{0} : fold(Operator::negate, basic, left);
    return {operation == Operator::divide ? left / right : left % right};
}

std::optional<bool> compared(Operator operation, auto left, auto right) {
    switch (operation) {
    case Operator::equal: return left == right;
    case Operator::unequal: return left != right;
    case Operator::less: return left < right;
    case Operator::greater: return left > right;
    case Operator::less_or_equal: return left <= right;
    case Operator::greater_or_equal: return left >= right;
    default: return std::nullopt;
    }
}

Folded fold_integers(Operator operation, Basic basic, std::int64_t left, std::int64_t right) {
    const auto a = static_cast<std::uint64_t>(left), b = static_cast<std::uint64_t>(right);
    std::int64_t result = 0;
    bool overflowed = false;
    switch (operation) {
    case Operator::add: overflowed = __builtin_add_overflow(left, right, &result); break;
    case Operator::subtract: overflowed = __builtin_sub_overflow(left, right, &result); break;
    case Operator::multiply: overflowed = __builtin_mul_overflow(left, right, &result); break;
    case Operator::divide:
    case Operator::remainder: return fold_division(operation, basic, left, right);
    case Operator::plus: return {wrapped(basic, a + b)};
    case Operator::minus: return {wrapped(basic, a - b)};
    case Operator::times: return {wrapped(basic, a * b)};
    case Operator::bit_and:
    case Operator::logical_and: return {left & right};
    case Operator::bit_or:
    case Operator::logical_or: return {left | right};
    case Operator::bit_xor: return {left ^ right};
    case Operator::after: return {wrapped(basic, a - b) > 0};
    default: return {*compared(operation, left, right)};
    }
    return fitting(basic, result, overflowed);
}

template <class Real>
using PatternOf = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
Real real_of(std::int64_t bits) {
    return std::bit_cast<Real>(static_cast<PatternOf<Real>>(bits));
}

template <class Real>
Folded folded(Real value) {
    return std::isfinite(value) ? Folded{static_cast<std::int64_t>(std::bit_cast<PatternOf<Real>>(value))} : not_finite;
}

template <class Real>
Folded fold_reals(Operator operation, Real left, Real right) {
    if (const std::optional<bool> truth = compared(operation, left, right))
        return {*truth};
    switch (operation) {
    case Operator::add: return folded<Real>(left + right);
    case Operator::subtract: return folded<Real>(left - right);
    case Operator::multiply: return folded<Real>(left * right);
    case Operator::divide: return right == 0 ? division_by_zero : folded<Real>(left / right);
    default: return right == 0 ? division_by_zero : folded<Real>(std::remainder(left, right));
    }
}

/// Rounds a real to the nearest integer (half to even), or truncates it.
template <class Real>
Folded integer_of(Real value, Basic to, Conversion::Rounding rounding) {
    const Real whole = rounding == Conversion::Rounding::round ? std::nearbyint(value) : std::trunc(value);
    const Real limit = std::ldexp(Real{1}, static_cast<int>(width_of(to)) - 1);
    if (!(whole >= -limit && whole < limit))
        return {0, "does not fit its type"};
    return {static_cast<std::int64_t>(whole)};
}

/// Converts a number to a real type, rounded to the nearest value, or toward zero if truncation is requested.
template <class To, class From>
Folded real_from(From value, Conversion::Rounding rounding) {
    To result = static_cast<To>(value);
    if (!std::isfinite(result))
        return not_finite;
    const bool is_away = static_cast<long double>(std::abs(result)) > std::abs(static_cast<long double>(value));
    if (rounding == Conversion::Rounding::truncate && is_away)
        result = std::nextafter(result, To{0});
    return folded<To>(result);
}

template <class From>
Folded to_real(From value, Basic to, Conversion::Rounding rounding) {
    return to == Basic::real32 ? real_from<float>(value, rounding) : real_from<double>(value, rounding);
}

template <class Real>
Folded digits_value(const std::string& digits) {
    Real value = 0;
    const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return result.ec == std::errc{} ? folded<Real>(value) : Folded{0, "is out of range"};
}

void append_scalar(std::vector<std::uint8_t>& bytes, Basic basic, std::int64_t bits) {
    for (std::uint32_t i = 0; i < bytes_of(basic); ++i)
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(bits) >> (8 * i)));
}

} // namespace

Folded fold(Operator operation, Basic basic, std::int64_t left, std::int64_t right) {
    if (operation == Operator::shift_left || operation == Operator::shift_right)
        return fold_shift(operation, basic, left, right);
    if (basic == Basic::real32)
        return fold_reals<float>(operation, real_of<float>(left), real_of<float>(right));
    if (basic == Basic::real64)
        return fold_reals<double>(operation, real_of<double>(left), real_of<double>(right));
    return fold_integers(operation, basic, left, right);
}

Folded fold(Operator operation, Basic basic, std::int64_t operand) {
    switch (operation) {
    case Operator::bit_not: return {wrapped(basic, ~static_cast<std::uint64_t>(operand))};
    case Operator::logical_not: return {!operand};
    case Operator::minus_modulo: return {wrapped(basic, 0 - static_cast<std::uint64_t>(operand))};
    default: break;
    }
    if (is_real(basic)) // the code of a program also subtracts the operand from zero
        return fold(Operator::subtract, basic, 0, operand);
    return operand == most_negative(basic) ? overflow : Folded{-operand};
}

Folded convert(Basic from, Basic to, Conversion::Rounding rounding, std::int64_t bits) {
    if (from == Basic::real32)
        return is_real(to) ? to_real(real_of<float>(bits), to, rounding)
                           : integer_of(real_of<float>(bits), to, rounding);
    if (from == Basic::real64)
        return is_real(to) ? to_real(real_of<double>(bits), to, rounding)
                           : integer_of(real_of<double>(bits), to, rounding);
    if (is_real(to))
        return to_real(bits, to, rounding);
    return wrapped(to, static_cast<std::uint64_t>(bits)) == bits ? Folded{bits} : Folded{0, "does not fit its type"};
}

Folded integer_value(std::uint64_t value, Basic basic, bool is_pattern, bool negative_allowed) {
    const auto bits = static_cast<std::int64_t>(value);
    const auto largest = static_cast<std::uint64_t>(most_positive(basic));
    const bool fits = is_pattern ? value == pattern(basic, bits) : value <= largest + (negative_allowed ? 1 : 0);
    return fits ? Folded{wrapped(basic, value)} : Folded{0, "is out of range"};
}

Folded real_value(const std::string& digits, Basic basic) {
    return basic == Basic::real32 ? digits_value<float>(digits) : digits_value<double>(digits);
}

std::int64_t most_positive(Basic basic) {
    switch (basic) {
    case Basic::boolean: return 1;
    case Basic::byte: return 255;
    case Basic::real32: return std::bit_cast<std::uint32_t>(std::numeric_limits<float>::max());
    case Basic::real64: return std::bit_cast<std::int64_t>(std::numeric_limits<double>::max());
    default: return static_cast<std::int64_t>(~std::uint64_t{0} >> (65 - width_of(basic)));
    }
}

std::int64_t most_negative(Basic basic) {
    switch (basic) {
    case Basic::boolean:
    case Basic::byte: return 0;
    case Basic::real32: return std::bit_cast<std::uint32_t>(std::numeric_limits<float>::lowest());
    case Basic::real64: return std::bit_cast<std::int64_t>(std::numeric_limits<double>::lowest());
    default: return -most_positive(basic) - 1;
    }
}

const Type& plain(const Type& type) { return type.kind == Type::Kind::derived ? plain(*type.element) : type; }

std::vector<std::uint8_t> memory_of(const Constant& constant, const Type& type) {
    if (constant.bytes)
        return *constant.bytes;
    std::vector<std::uint8_t> bytes;
    append_scalar(bytes, plain(type).basic, constant.bits);
    return bytes;
}

Constant constant_of(const std::vector<std::uint8_t>& bytes, std::size_t offset, const Type& type) {
    const Type& form = plain(type);
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    if (form.kind != Type::Kind::basic)
        return {0, std::make_shared<const std::vector<std::uint8_t>>(
                       first, first + static_cast<std::ptrdiff_t>(bytes_of(type)))};
    std::uint64_t bits = 0;
    for (std::uint32_t i = bytes_of(form.basic); i-- > 0;)
        bits = bits << 8 | bytes[offset + i];
    return {wrapped(form.basic, bits), nullptr};
}

} // namespace placedpar::occam
