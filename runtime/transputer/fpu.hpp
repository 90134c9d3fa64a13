#pragma once

#include "runtime/transputer/real_pattern.hpp"

#include <cstdint>

namespace placedpar::transputer {

enum class Length : std::uint8_t { real32, real64 };

struct Real {
    /// A REAL32 is in the lower half. The upper half is 0, except after fpunoround. It then has the 29 bits of a
    /// REAL64's fraction that a REAL32 lacks; a store drops these bits.
    std::uint64_t bits = 0;
    Length length = Length::real32;

    friend bool operator==(const Real&, const Real&) = default;
};

enum class Rounding : std::uint8_t { nearest, zero, plus, minus };

enum class RealOperation : std::uint8_t { add, subtract, multiply, divide };

/// Returns left op right, computed by the host's processor in its rounding mode.
template <typename T>
T computed_on_host(RealOperation operation, T left, T right) {
    switch (operation) {
    case RealOperation::add: return left + right;
    case RealOperation::subtract: return left - right;
    case RealOperation::multiply: return left * right;
    case RealOperation::divide: return left / right;
    }
    return 0;
}

/// The floating-point unit of a T800 or T805: the stack of FA, FB and FC, the rounding mode and FPError. Each operation
/// has a method with its name, which changes the stack and the flag. The caller accounts for the time and for the
/// effect on the integer stack. The object is a plain value: an interrupt saves the unit by a copy.
///
/// The rules are those of INMOS, "Transputer instruction set: a compiler writer's guide". Arithmetic follows IEEE 754.
/// - Each operation rounds in the current mode, to the precision of its result. Each operation sets the mode to
/// nearest, except the four operations that set another mode.
/// - FPError is set by a NaN or infinity as an operand, an invalid operation, a division by 0, and overflow. Loads,
/// stores, exchanges and the tests fpnan, fpordered and fpnotfinite never set it. Only fptesterror and fpuclearerror
/// clear it.
/// - If one operand is a NaN, this NaN is the result. If both are NaNs, the NaN with the larger fraction is the result,
///   or FB if the fractions are equal. The sign follows the operation: fpsub negates FA's sign, fpmul and fpdiv
///   multiply the signs.
/// - An invalid operation gives a NaN that identifies the operation: see `MadeNan` in the source.
/// - A pop leaves FC unchanged.
///
/// REQUIRES: the operands of an operation have equal lengths, as on the machine. Otherwise FB is read in FA's length.
/// REQUIRES: the calling thread rounds to nearest (std::fegetround); the methods keep this mode.
class Fpu {
public:
    const Real& fa() const { return a_; }
    const Real& fb() const { return b_; }
    const Real& fc() const { return c_; }
    Rounding rounding() const { return rounding_; }
    bool error() const { return error_; }

    /// These push a real that the caller has read from memory. They serve the indexed loads, too.
    void fpldnlsn(std::uint32_t bits) { push({bits, Length::real32}); }
    void fpldnldb(std::uint64_t bits) { push({bits, Length::real64}); }
    void fpldzerosn() { push({0, Length::real32}); }
    void fpldzerodb() { push({0, Length::real64}); }

    /// These add to FA, or multiply FA by, an operand that the caller has read from memory.
    void fpldnladdsn(std::uint32_t bits) { combine(RealOperation::add, a_, {bits, Length::real32}); }
    void fpldnladddb(std::uint64_t bits) { combine(RealOperation::add, a_, {bits, Length::real64}); }
    void fpldnlmulsn(std::uint32_t bits) { combine(RealOperation::multiply, a_, {bits, Length::real32}); }
    void fpldnlmuldb(std::uint64_t bits) { combine(RealOperation::multiply, a_, {bits, Length::real64}); }

    /// These pop FA and return the bits to store. fpstnli32 returns the largest integer up to FA, modulo 2^32; for a
    /// NaN or infinity it returns 0. Programs use fpstnli32 to get the two halves of a long integer.
    std::uint32_t fpstnlsn() { return std::uint32_t(pop().bits); }
    std::uint64_t fpstnldb() { return pop().bits; }
    std::uint32_t fpstnli32();

    void fprev();
    void fpdup() { push(Real(a_)); }

    /// These compute FB op FA.
    void fpadd() { combine_two(RealOperation::add); }
    void fpsub() { combine_two(RealOperation::subtract); }
    void fpmul() { combine_two(RealOperation::multiply); }
    void fpdiv() { combine_two(RealOperation::divide); }

    /// These compute the remainder: FA := FB - q * FA, FB := q, where q is the integer nearest to FB / FA. The
    /// remainder is exact. The quotient is right if FB's exponent is at most 20 (REAL64: 30) above FA's. Otherwise the
    /// machine's quotient is undefined, and here it is the rounded quotient. The real machine needs several steps. Here
    /// the first step computes the whole remainder, and both functions return TRUE (complete) for register A. Then the
    /// usual code `fpremfirst; eqc 0; cj done; more: fpremstep; cj more; done:` executes no further step.
    bool fpremfirst();
    bool fpremstep() { return finished(true); }

    /// These compare: FB > FA, FB = FA. They pop both operands, and return FALSE if one of them is a NaN.
    bool fpgt();
    bool fpeq();
    /// These test FA; fpordered tests FA and FB. They pop nothing.
    bool fpordered();
    bool fpnan();
    bool fpnotfinite();

    /// Returns FPError, which the integer unit ORs into Error.
    bool fpchkerror() { return finished(error_); }
    /// Returns TRUE if FPError is not set. Clears FPError.
    bool fptesterror();
    void fpuseterror() { set_error(true); }
    void fpuclearerror() { set_error(false); }

    /// These set the mode for the next operation.
    void fpurn() { rounding_ = Rounding::nearest; }
    void fpurz() { rounding_ = Rounding::zero; }
    void fpurp() { rounding_ = Rounding::plus; }
    void fpurm() { rounding_ = Rounding::minus; }

    /// These push an integer as a real. Only fpi32tor32 rounds.
    void fpi32tor32(std::uint32_t word);
    void fpi32tor64(std::uint32_t word) { push_exactly(double(std::int32_t(word))); }
    void fpb32tor64(std::uint32_t word) { push_exactly(double(word)); }

    /// Rounds FA to an integer. fprtoi32 also checks that the integer is in the range of 32 bits.
    void fpint();
    void fprtoi32();
    /// fpuchki32 sets FPError unless -2^31 <= FA < 2^31; fpuchki64, unless -2^63 <= FA < 2^63.
    void fpuchki32() { check_below(0x1p31); }
    void fpuchki64() { check_below(0x1p63); }

    void fpur32tor64();
    void fpur64tor32();
    /// Makes FA, a REAL64, a REAL32 that keeps the whole fraction, but only the lower bits of the exponent. Sets no
    /// flag. The next operation computes with the whole fraction. INMOS's code uses this to add the halves of an INT64
    /// with a single rounding.
    void fpunoround();

    void fpuabs();
    void fpuexpinc32() { scale(0x1p32F); }
    void fpuexpdec32() { scale(0x1p-32F); }
    void fpumulby2() { scale(2); }
    void fpudivby2() { scale(0.5F); }
    /// The first step sets FA to its square root. The other steps of the real machine's algorithm only set the mode to
    /// nearest.
    void fpusqrtfirst();
    void fpusqrtstep() { rounding_ = Rounding::nearest; }
    void fpusqrtlast() { rounding_ = Rounding::nearest; }

    friend bool operator==(const Fpu&, const Fpu&) = default;

private:
    template <typename T>
    bool combined_at_once(RealOperation operation, const Real& left, const Real& right);
    void combine(RealOperation operation, const Real& left, const Real& right);
    void combine_by_rules(RealOperation operation, const Real& left, const Real& right);
    void combine_two(RealOperation operation);
    void scale(float factor);
    void check_below(double limit);
    void push(const Real& real);
    void push_exactly(double value) { push({RealPattern<double>::of(value).word(), Length::real64}); }
    Real pop();
    void set_error(bool error);
    /// Returns the answer of an operation that changes only the mode.
    bool finished(bool answer);

    Real a_, b_, c_;
    Rounding rounding_ = Rounding::nearest;
    bool error_ = false;
};

inline void Fpu::push(const Real& real) {
    c_ = b_;
    b_ = a_;
    a_ = real;
    rounding_ = Rounding::nearest;
}

inline Real Fpu::pop() {
    Real top = a_;
    a_ = b_;
    b_ = c_;
    rounding_ = Rounding::nearest;
    return top;
}

/// Computes on the host's processor, and returns true, if the operands and the result are finite. Then rounding to
/// nearest is the only rule that matters.
template <typename T>
bool Fpu::combined_at_once(RealOperation operation, const Real& left, const Real& right) {
    const RealPattern<T> first(left.bits), second(right.bits);
    const auto result = RealPattern<T>::of(computed_on_host(operation, first.value(), second.value()));
    if (!result.finite() || (operation == RealOperation::divide && !second.finite()))
        return false;
    a_ = {result.word(), right.length};
    return true;
}

/// FA := left op right. The right operand determines the length.
inline void Fpu::combine(RealOperation operation, const Real& left, const Real& right) {
    if (rounding_ == Rounding::nearest) {
        if (right.length == Length::real32
                ? (left.bits | right.bits) >> 32 == 0 && combined_at_once<float>(operation, left, right)
                : combined_at_once<double>(operation, left, right))
            return;
    }
    combine_by_rules(operation, left, right);
}

inline void Fpu::combine_two(RealOperation operation) {
    combine(operation, b_, a_);
    b_ = c_;
}

inline void Fpu::fprev() {
    const Real top = a_;
    a_ = b_;
    b_ = top;
    rounding_ = Rounding::nearest;
}

inline bool Fpu::finished(bool answer) {
    rounding_ = Rounding::nearest;
    return answer;
}

} // namespace placedpar::transputer
