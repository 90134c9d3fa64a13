// The floating-point unit, by the host's arithmetic, which is that of IEEE 754. Its NaNs may have other bits.

#include "plain_transputer.hpp"

#include <fmt/format.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <limits>
#include <utility>

namespace placedpar::test {

namespace plain_reals {

using P = PlainTransputer;
using Word = P::Word;

constexpr unsigned entry = 0x1000;
constexpr int host_modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

double value(const P::Real& real) {
    return real.is_double ? std::bit_cast<double>(real.bits)
                          : static_cast<double>(std::bit_cast<float>(static_cast<Word>(real.bits)));
}

P::Real real(double number) { return {std::bit_cast<std::uint64_t>(number), true}; }
P::Real real(float number) { return {std::bit_cast<Word>(number), false}; }

void push_real(P& p, P::Real number) {
    p.unit.f[2] = p.unit.f[1];
    p.unit.f[1] = p.unit.f[0];
    p.unit.f[0] = number;
}

P::Real pop_real(P& p) {
    const auto number = p.unit.f[0];
    p.unit.f[0] = p.unit.f[1];
    p.unit.f[1] = p.unit.f[2];
    return number;
}

P::Real load_real(P& p, Word address, bool is_double) {
    const std::uint64_t lower = p.load(address);
    return {is_double ? lower | std::uint64_t{p.load(address + 4)} << 32 : lower, is_double};
}

void load_and_push(P& p, bool is_double, bool indexed = false) {
    const Word base = p.pop(), index = indexed ? p.pop() : 0;
    push_real(p, load_real(p, base + (is_double ? 8 : 4) * index, is_double));
}

void store_and_pop(P& p, bool is_double) {
    const Word address = p.pop();
    const auto number = pop_real(p);
    p.store(address, static_cast<Word>(number.bits));
    if (is_double)
        p.store(address + 4, static_cast<Word>(number.bits >> 32));
}

/// Computes in the unit's rounding mode, and sets FPError if the host overflows, divides by zero, or finds no answer.
template <class Formula>
auto rounded(P& p, const Formula& formula) {
    std::fesetround(host_modes[p.unit.rounding]);
    std::feclearexcept(FE_ALL_EXCEPT);
    const volatile auto result = formula();
    p.unit.error |= std::fetestexcept(FE_OVERFLOW | FE_DIVBYZERO | FE_INVALID) != 0;
    std::fesetround(FE_TONEAREST);
    return P::Real{real(+result)};
}

void check_operand(P& p, const P::Real& number) { p.unit.error |= !std::isfinite(value(number)); }

template <class Number>
P::Real computed(P& p, char sign, P::Real left, P::Real right) {
    const volatile Number x = static_cast<Number>(value(left)), y = static_cast<Number>(value(right));
    switch (sign) {
    case '+': return rounded(p, [&]() -> Number { return x + y; });
    case '-': return rounded(p, [&]() -> Number { return x - y; });
    case '*': return rounded(p, [&]() -> Number { return x * y; });
    case '/': return rounded(p, [&]() -> Number { return x / y; });
    default: return rounded(p, [&]() -> Number { return std::sqrt(x); });
    }
}

P::Real computed(P& p, char sign, P::Real left, P::Real right) {
    check_operand(p, left);
    check_operand(p, right);
    return left.is_double ? computed<double>(p, sign, left, right) : computed<float>(p, sign, left, right);
}

void compute(P& p, char sign) {
    const auto right = pop_real(p);
    p.unit.f[0] = computed(p, sign, p.unit.f[0], right);
}

void compute_with_memory(P& p, char sign, bool is_double) {
    p.unit.f[0] = computed(p, sign, p.unit.f[0], load_real(p, p.pop(), is_double));
}

void scale(P& p, char sign, double factor) {
    p.unit.f[0] =
        computed(p, sign, p.unit.f[0], p.unit.f[0].is_double ? real(factor) : real(static_cast<float>(factor)));
}

/// Rounds a number to a whole one.
void round_whole(P& p) {
    check_operand(p, p.unit.f[0]);
    const volatile double number = value(p.unit.f[0]);
    const auto whole = rounded(p, [&] { return std::nearbyint(number); });
    p.unit.f[0] = p.unit.f[0].is_double ? whole : real(static_cast<float>(value(whole)));
}

void check_range(P& p, double limit) {
    check_operand(p, p.unit.f[0]);
    const double number = value(p.unit.f[0]);
    p.unit.error |= number >= limit || number < -limit;
}

void convert_whole(P& p, bool is_signed, bool is_double) {
    const Word word = p.load(p.pop());
    const double number = is_signed ? double(static_cast<std::int32_t>(word)) : double(word);
    const volatile double exact = number;
    push_real(p, is_double ? real(number) : rounded(p, [&] { return static_cast<float>(exact); }));
}

void store_whole(P& p) {
    const double number = value(pop_real(p));
    p.store(p.pop(), std::abs(number) < 0x1p63 ? static_cast<Word>(static_cast<std::int64_t>(number)) : 0);
}

void compare(P& p, bool greater) {
    const auto right = pop_real(p), left = pop_real(p);
    check_operand(p, left);
    check_operand(p, right);
    p.push(greater ? value(left) > value(right) : value(left) == value(right));
}

void change_length(P& p, bool to_double) {
    check_operand(p, p.unit.f[0]);
    const volatile double number = value(p.unit.f[0]);
    p.unit.f[0] = to_double ? real(number) : rounded(p, [&] { return static_cast<float>(number); });
}

constexpr Word sign_bit = 0x80000000;
constexpr PlainRealOperation table[] = {
    {0x8E, "fpldnlsn", 2, 2, false, [](P& p) { load_and_push(p, false); }},
    {0x8A, "fpldnldb", 3, 3, false, [](P& p) { load_and_push(p, true); }},
    {0x86, "fpldnlsni", 4, 4, false, [](P& p) { load_and_push(p, false, true); }},
    {0x82, "fpldnldbi", 6, 6, false, [](P& p) { load_and_push(p, true, true); }},
    {0x9F, "fpldzerosn", 2, 2, false, [](P& p) { push_real(p, real(0.0F)); }},
    {0xA0, "fpldzerodb", 2, 2, false, [](P& p) { push_real(p, real(0.0)); }},
    {0xAA, "fpldnladdsn", 8, 8, false, [](P& p) { compute_with_memory(p, '+', false); }},
    {0xA6, "fpldnladddb", 9, 9, false, [](P& p) { compute_with_memory(p, '+', true); }},
    {0xAC, "fpldnlmulsn", 13, 13, false, [](P& p) { compute_with_memory(p, '*', false); }},
    {0xA8, "fpldnlmuldb", 21, 21, false, [](P& p) { compute_with_memory(p, '*', true); }},
    {0x88, "fpstnlsn", 2, 2, true, [](P& p) { store_and_pop(p, false); }},
    {0x84, "fpstnldb", 3, 3, true, [](P& p) { store_and_pop(p, true); }},
    {0x9E, "fpstnli32", 4, 4, true, store_whole},
    {0xA4, "fprev", 1, 1, false, [](P& p) { std::swap(p.unit.f[0], p.unit.f[1]); }},
    {0xA3, "fpdup", 1, 1, false, [](P& p) { push_real(p, p.unit.f[0]); }},
    {0x83, "fpchkerror", 1, 1, true,
     [](P& p) {
         if (p.unit.error)
             p.set_error();
     }},
    {0x9C, "fptesterror", 2, 2, true, [](P& p) { p.push(!std::exchange(p.unit.error, false)); }},
    {0x87, "fpadd", 6, 6, false, [](P& p) { compute(p, '+'); }},
    {0x89, "fpsub", 6, 6, false, [](P& p) { compute(p, '-'); }},
    {0x8B, "fpmul", 11, 18, false, [](P& p) { compute(p, '*'); }},
    {0x8C, "fpdiv", 16, 31, false, [](P& p) { compute(p, '/'); }},
    {0x96, "fpi32tor32", 8, 8, false, [](P& p) { convert_whole(p, true, false); }},
    {0x98, "fpi32tor64", 8, 8, false, [](P& p) { convert_whole(p, true, true); }},
    {0x9A, "fpb32tor64", 8, 8, false, [](P& p) { convert_whole(p, false, true); }},
    {0x9D, "fprtoi32", 7, 7, false, [](P& p) { round_whole(p), check_range(p, 0x1p31); }},
    {0xA1, "fpint", 5, 5, false, round_whole},
    {0x94, "fpgt", 4, 4, true, [](P& p) { compare(p, true); }},
    {0x95, "fpeq", 3, 3, true, [](P& p) { compare(p, false); }},
    {0x92, "fpordered", 3, 3, true,
     [](P& p) { p.push(!std::isnan(value(p.unit.f[0])) && !std::isnan(value(p.unit.f[1]))); }},
    {0x91, "fpnan", 2, 2, true, [](P& p) { p.push(std::isnan(value(p.unit.f[0]))); }},
    {0x93, "fpnotfinite", 2, 2, true, [](P& p) { p.push(!std::isfinite(value(p.unit.f[0]))); }},
    {entry + 0x22, "fpurn", 1, 1, false, [](P& p) { p.unit.rounding = 0; }},
    {entry + 0x04, "fpurp", 1, 1, false, [](P& p) { p.unit.rounding = 1; }},
    {entry + 0x05, "fpurm", 1, 1, false, [](P& p) { p.unit.rounding = 2; }},
    {entry + 0x06, "fpurz", 1, 1, false, [](P& p) { p.unit.rounding = 3; }},
    {entry + 0x23, "fpuseterror", 1, 1, false, [](P& p) { p.unit.error = true; }},
    {entry + 0x9C, "fpuclearerror", 1, 1, false, [](P& p) { p.unit.error = false; }},
    {entry + 0x0E, "fpuchki32", 3, 3, false, [](P& p) { check_range(p, 0x1p31); }},
    {entry + 0x0F, "fpuchki64", 3, 3, false, [](P& p) { check_range(p, 0x1p63); }},
    {entry + 0x07, "fpur32tor64", 3, 3, false, [](P& p) { change_length(p, true); }},
    {entry + 0x08, "fpur64tor32", 6, 6, false, [](P& p) { change_length(p, false); }},
    {entry + 0x0B, "fpuabs", 2, 2, false,
     [](P& p) {
         check_operand(p, p.unit.f[0]);
         p.unit.f[0].bits &= ~(std::uint64_t{sign_bit} << (p.unit.f[0].is_double ? 32 : 0));
     }},
    {entry + 0x0A, "fpuexpinc32", 6, 6, false, [](P& p) { scale(p, '*', 0x1p32); }},
    {entry + 0x09, "fpuexpdec32", 6, 6, false, [](P& p) { scale(p, '/', 0x1p32); }},
    {entry + 0x12, "fpumulby2", 6, 6, false, [](P& p) { scale(p, '*', 2); }},
    {entry + 0x11, "fpudivby2", 6, 6, false, [](P& p) { scale(p, '/', 2); }},
    {entry + 0x01, "fpusqrtfirst", 27, 27, false,
     [](P& p) { p.unit.f[0] = computed(p, 's', p.unit.f[0], p.unit.f[0]); }},
    {entry + 0x02, "fpusqrtstep", 42, 42, false, [](P&) {}},
    {entry + 0x03, "fpusqrtlast", 8, 8, false, [](P&) {}},
};

} // namespace plain_reals

const std::span<const PlainRealOperation> plain_real_operations = plain_reals::table;

/// Waits until the unit is free. Then the unit works on its own, unless the integer unit needs the result.
bool PlainTransputer::execute_floating_point(unsigned code) {
    if (!(settings.model & (t800 | t805)))
        return false;
    if (code == 0xAB)
        code = plain_reals::entry + std::min(pop(), Word{0xFFF});
    for (const auto& row : plain_real_operations) {
        if (row.code != code)
            continue;
        const std::uint64_t start = now + 2 * cycles + extra, wait = fpu_free > start ? fpu_free - start : 0;
        const auto row_cycles = unit.f[0].is_double ? row.double_cycles : row.single_cycles;
        extra += wait;
        row.effect(*this);
        cycles += row.waits ? row_cycles : 1;
        fpu_free = start + wait + 2 * row_cycles;
        const bool sets_rounding =
            code == plain_reals::entry + 0x22 || (code >= plain_reals::entry + 4 && code <= plain_reals::entry + 6);
        unit.rounding = sets_rounding ? unit.rounding : 0;
        return true;
    }
    return false;
}

} // namespace placedpar::test
