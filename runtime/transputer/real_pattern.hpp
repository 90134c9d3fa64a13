#pragma once

#include <bit>
#include <cfloat>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace placedpar::transputer {

static_assert(FLT_EVAL_METHOD == 0, "float and double are computed in their own precision, not on an x87");

/// The bits of a REAL32 (T is float) or of a REAL64 (T is double).
template <typename T>
class RealPattern {
public:
    using Word = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    static constexpr int fraction_bits = std::numeric_limits<T>::digits - 1;
    static constexpr Word sign_mask = Word(1) << (8 * sizeof(T) - 1);
    static constexpr Word fraction_mask = (Word(1) << fraction_bits) - 1;
    static constexpr Word exponent_mask = Word(~(sign_mask | fraction_mask));

    explicit constexpr RealPattern(std::uint64_t bits) : word_(Word(bits)) {}
    static constexpr RealPattern of(T value) { return RealPattern(std::bit_cast<Word>(value)); }

    constexpr Word word() const { return word_; }
    constexpr T value() const { return std::bit_cast<T>(word_); }
    constexpr Word fraction() const { return word_ & fraction_mask; }
    constexpr bool negative() const { return (word_ & sign_mask) != 0; }
    constexpr bool zero() const { return magnitude() == 0; }
    constexpr bool finite() const { return magnitude() < exponent_mask; }
    constexpr bool infinite() const { return magnitude() == exponent_mask; }
    constexpr bool nan() const { return magnitude() > exponent_mask; }

    constexpr RealPattern absolute() const { return RealPattern(magnitude()); }
    constexpr RealPattern negated() const { return RealPattern(word_ ^ sign_mask); }
    constexpr RealPattern with_sign(bool minus) const { return minus ? absolute().negated() : absolute(); }

private:
    constexpr Word magnitude() const { return word_ & Word(~sign_mask); }

    Word word_;
};

} // namespace placedpar::transputer
