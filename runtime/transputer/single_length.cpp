#include "runtime/transputer/single_length.hpp"

#include "runtime/transputer/real_pattern.hpp"

namespace placedpar::transputer {

namespace {

using Single = RealPattern<float>;

constexpr std::uint32_t hidden_bit = 0x80000000, greatest_exponent = 255;

SingleLengthClass class_of(Single real) {
    if (real.zero())
        return SingleLengthClass::zero;
    if (real.finite())
        return SingleLengthClass::finite;
    return real.infinite() ? SingleLengthClass::infinite : SingleLengthClass::nan;
}

} // namespace

SingleLengthRegisters unpacksn(SingleLengthRegisters registers) {
    const Single real(registers.a);
    const std::uint32_t fraction = real.fraction() << 8, exponent = (real.word() & Single::exponent_mask) >> 23;
    const SingleLengthClass kind = class_of(real);
    const std::uint32_t c = 4 * registers.b + std::uint32_t(kind);
    if (kind != SingleLengthClass::finite)
        return {fraction, exponent, c};
    if (exponent == 0)
        return {fraction, 1, c};
    return {fraction | hidden_bit, exponent, c};
}

SingleLengthRegisters postnormsn(SingleLengthRegisters registers, std::uint32_t workspace) {
    const auto exponent = std::int32_t(workspace - registers.c);
    if (exponent < -31)
        return {0, 0, 0};
    if (exponent > 0)
        return {registers.a, registers.b, exponent > 255 ? greatest_exponent : std::uint32_t(exponent)};
    const std::uint64_t fraction = (std::uint64_t(registers.b) << 32 | registers.a) >> (1 - exponent);
    // the new A contains all bits of the old A, because the next instruction, roundsn, tests only whether A is 0
    return {std::uint32_t(fraction) | registers.a, std::uint32_t(fraction >> 32), 0};
}

SingleLengthRegisters roundsn(SingleLengthRegisters registers) {
    const auto [a, b, c] = registers;
    if (std::int32_t(c) >= std::int32_t(greatest_exponent))
        return {Single::exponent_mask, b, b << 1};
    const std::uint32_t packed = c << 23 | (b & ~hidden_bit) >> 8;
    const bool half = (b & 0x80) != 0, beyond_half = a != 0 || (b & 0x7F) != 0, odd = (packed & 1) != 0;
    const std::uint32_t rounded = packed + std::uint32_t(half && (beyond_half || odd));
    return {rounded, rounded, c >> 9};
}

SingleLengthRegisters ldinf(SingleLengthRegisters registers) {
    return {Single::exponent_mask, registers.a, registers.b};
}

bool cflerr(SingleLengthRegisters registers) { return !Single(registers.a).finite(); }

} // namespace placedpar::transputer
