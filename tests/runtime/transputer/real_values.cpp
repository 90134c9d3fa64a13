#include "tests/runtime/transputer/real_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace placedpar::test {

using namespace transputer;

namespace {

int fraction_bits(Length length) { return length == Length::real32 ? 23 : 52; }
int greatest_exponent(Length length) { return length == Length::real32 ? 254 : 2046; }
std::int64_t exponent_of(Real real) {
    return std::int64_t(real.bits >> fraction_bits(real.length)) & (greatest_exponent(real.length) + 1);
}

template <typename T>
std::vector<Real> special() {
    using Limits = std::numeric_limits<T>;
    std::vector<T> values{0, Limits::denorm_min(), 2 * Limits::denorm_min(), Limits::min() - Limits::denorm_min()};
    for (T each : {Limits::min(), T(0.5), T(1), T(0x1p31), T(0x1p63)})
        for (T toward : {T(0), each, Limits::max()})
            values.push_back(std::nextafter(each, toward));
    for (double each : {1.5, 2.0, 2.5, 3.0, 2147483647.5, 0x1p32, 0x1p-32})
        values.push_back(T(each));
    const T top = std::ldexp(T(1), Limits::digits); // from here on all are even integers
    for (T each : {top, T(top - 1), T(top / 2 + T(0.5)), Limits::max(), std::nextafter(Limits::max(), T(0)),
                   T(Limits::max() / 2), Limits::infinity()})
        values.push_back(each);

    std::vector<Real> reals;
    for (T each : values)
        for (T signed_value : {each, T(-each)})
            reals.push_back(real(signed_value));
    const auto infinity = RealPattern<T>::exponent_mask;
    for (std::uint64_t fraction : {std::uint64_t(1), std::uint64_t(RealPattern<T>::fraction_mask)})
        for (std::uint64_t sign : {std::uint64_t(0), std::uint64_t(RealPattern<T>::sign_mask)})
            reals.push_back(real_with_bits<T>(sign | infinity | fraction));
    return reals;
}

} // namespace

std::vector<Real> special_reals(Length length) {
    return length == Length::real32 ? special<float>() : special<double>();
}

/// Returns a fraction: any, or one with few ones at either end, which make ties.
std::uint64_t RandomReals::fraction() {
    const int bits = fraction_bits(length_);
    const std::uint64_t mask = (std::uint64_t(1) << bits) - 1;
    const std::uint64_t any = std::uint64_t(random_()) << 32 | random_();
    switch (below(4)) {
    case 0: return any & mask;
    case 1: return (below(8) << (bits - 3)) & mask;
    case 2: return below(8);
    default: return (std::uint64_t(0) - below(8)) & mask;
    }
}

Real RandomReals::with_exponent(std::int64_t exponent) {
    const int bits = fraction_bits(length_);
    const auto limited = std::uint64_t(std::clamp<std::int64_t>(exponent, 0, greatest_exponent(length_)));
    const std::uint64_t sign = below(2) << (length_ == Length::real32 ? 31 : 63);
    return {sign | limited << bits | fraction(), length_};
}

Real RandomReals::finite() {
    switch (below(3)) {
    case 0: return with_exponent(std::int64_t(below(4)));
    case 1: return with_exponent(greatest_exponent(length_) - std::int64_t(below(4)));
    default: return with_exponent(std::int64_t(below(std::uint64_t(greatest_exponent(length_)) + 1)));
    }
}

Real RandomReals::finite_beside(Real other) {
    const std::int64_t exponent = exponent_of(other), most = greatest_exponent(length_), bias = most / 2;
    const auto near = std::int64_t(below(5)) - 2;
    switch (below(7)) {
    case 0: return with_exponent(exponent + near);                                                // cancellation
    case 1: return with_exponent(exponent + near + fraction_bits(length_) * (below(2) ? 1 : -1)); // ties of sums
    case 2: return with_exponent(most + bias - exponent + near);                 // a product that overflows
    case 3: return with_exponent(bias - exponent - std::int64_t(below(60)) + 3); // a denormal product
    case 4: return with_exponent(exponent - bias - near);                        // a quotient that overflows
    case 5: return with_exponent(exponent + bias + std::int64_t(below(60)) - 3); // a denormal quotient
    default: return finite();
    }
}

} // namespace placedpar::test
