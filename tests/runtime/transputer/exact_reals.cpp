#include "tests/runtime/transputer/exact_reals.hpp"

#include <mpfr.h>

#include <array>
#include <stdexcept>

namespace placedpar::test {

using namespace transputer;

namespace {

constexpr mpfr_prec_t wide = 2'200; // holds the difference of any two reals

constexpr mpfr_prec_t precision(Length length) { return length == Length::real32 ? 24 : 53; }

mpfr_rnd_t mode(Rounding rounding) {
    static constexpr std::array modes{MPFR_RNDN, MPFR_RNDZ, MPFR_RNDU, MPFR_RNDD};
    return modes[std::size_t(rounding)];
}

/// A number of MPFR.
class Number {
public:
    explicit Number(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
    explicit Number(Real real) : Number(precision(real.length)) {
        mpfr_set_d(value_,
                   real.length == Length::real32 ? double(RealPattern<float>(real.bits).value())
                                                 : RealPattern<double>(real.bits).value(),
                   MPFR_RNDN);
    }
    ~Number() { mpfr_clear(value_); }
    Number(const Number&) = delete;
    Number& operator=(const Number&) = delete;

    operator mpfr_ptr() { return value_; }
    operator mpfr_srcptr() const { return value_; }

    Real real(Length length) const {
        if (length == Length::real32)
            return {RealPattern<float>::of(mpfr_get_flt(value_, MPFR_RNDN)).word(), length};
        return {RealPattern<double>::of(mpfr_get_d(value_, MPFR_RNDN)).word(), length};
    }

private:
    mpfr_t value_;
};

/// Puts a number with the precision of a length into its range of exponents. `direction` is that in which the number
/// was rounded.
ExactReal in_range(Number& number, int direction, Rounding rounding, Length length) {
    const mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
    mpfr_set_emin(length == Length::real32 ? -148 : -1073); // 2^-149 and 2^-1074: MPFR's fractions are below 1
    mpfr_set_emax(length == Length::real32 ? 128 : 1024);
    mpfr_clear_overflow();
    direction = mpfr_check_range(number, direction, mode(rounding));
    mpfr_subnormalize(number, direction, mode(rounding));
    const bool overflow = mpfr_overflow_p() != 0;
    mpfr_set_emin(least);
    mpfr_set_emax(most);
    return {number.real(length), overflow};
}

int compute(ExactOperation operation, mpfr_rnd_t rounding, Number& result, const Number& left, const Number& right) {
    switch (operation) {
    case ExactOperation::add: return mpfr_add(result, left, right, rounding);
    case ExactOperation::subtract: return mpfr_sub(result, left, right, rounding);
    case ExactOperation::multiply: return mpfr_mul(result, left, right, rounding);
    case ExactOperation::divide: return mpfr_div(result, left, right, rounding);
    case ExactOperation::remainder: return mpfr_remainder(result, left, right, rounding);
    case ExactOperation::root: return mpfr_sqrt(result, left, rounding);
    case ExactOperation::integer: return mpfr_rint(result, left, rounding);
    case ExactOperation::converted: return mpfr_set(result, static_cast<mpfr_srcptr>(left), rounding);
    }
    throw std::invalid_argument("an operation that MPFR is not asked for");
}

} // namespace

ExactReal exact(ExactOperation operation, Rounding rounding, Length length, Real left, Real right) {
    Number result(precision(length));
    const int direction = compute(operation, mode(rounding), result, Number(left), Number(right));
    // mpfr_rint tells by 2 and -2 that the number was no integer
    return in_range(result, operation == ExactOperation::integer ? 0 : direction, rounding, length);
}

ExactReal exactly_scaled(Rounding rounding, Real left, int exponent) {
    Number result(precision(left.length));
    const int direction = mpfr_mul_2si(result, Number(left), exponent, mode(rounding));
    return in_range(result, direction, rounding, left.length);
}

ExactReal exact_integer(Rounding rounding, Length length, std::int64_t integer) {
    Number result(precision(length));
    const int direction = mpfr_set_si(result, integer, mode(rounding));
    return in_range(result, direction, rounding, length);
}

Real exact_quotient(Real left, Real right, Real remainder) {
    Number quotient(wide);
    mpfr_sub(quotient, Number(left), Number(remainder), MPFR_RNDN);
    if (mpfr_div(quotient, quotient, Number(right), MPFR_RNDN) != 0 || mpfr_integer_p(quotient) == 0)
        throw std::invalid_argument("the remainder belongs to no integral quotient");
    return quotient.real(left.length);
}

int exactly_compared(Real left, Real right) {
    const int order = mpfr_cmp(Number(left), Number(right));
    return order < 0 ? -1 : order > 0;
}

bool exactly_within(Real real, int bits) {
    const Number number(real);
    Number limit(64);
    mpfr_set_si_2exp(limit, 1, bits, MPFR_RNDN);
    const bool below = mpfr_less_p(number, limit) != 0;
    mpfr_neg(limit, limit, MPFR_RNDN);
    return below && mpfr_greaterequal_p(number, limit) != 0;
}

std::uint32_t exact_low_word(Real real) {
    const Number number(real);
    mpz_t integer;
    mpz_init(integer);
    mpfr_get_z(integer, number, MPFR_RNDD);
    mpz_fdiv_r_2exp(integer, integer, 32);
    const auto word = std::uint32_t(mpz_get_ui(integer));
    mpz_clear(integer);
    return word;
}

} // namespace placedpar::test
