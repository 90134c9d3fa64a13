// Operations of the integer unit that do not touch processes.

#include "plain_transputer.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace placedpar::test {

namespace plain_integers {

using P = PlainTransputer;
using Word = P::Word;

constexpr unsigned all = t414 | t425 | t400 | t800 | t805, t8 = t800 | t805, newer = t425 | t400 | t800 | t805;
constexpr unsigned debugged = t425 | t400 | t805;

std::int64_t wide(Word word) { return static_cast<std::int32_t>(word); }
Word low(std::uint64_t value) { return static_cast<Word>(value); }
Word high(std::uint64_t value) { return static_cast<Word>(value >> 32); }
std::uint64_t pair(Word upper, Word lower) { return std::uint64_t{upper} << 32 | lower; }
/// Returns the number of the highest bit that is set; 0 if no bit is set.
unsigned top_bit(Word word) { return word ? static_cast<unsigned>(std::bit_width(word)) - 1 : 0; }

/// Returns the low word of a signed result, and sets Error if the result does not fit.
Word checked(P& p, std::int64_t value) {
    if (value != wide(low(static_cast<std::uint64_t>(value))))
        p.set_error();
    return low(static_cast<std::uint64_t>(value));
}

void multiply(P& p) {
    p.cycles -= p.settings.model == t414 ? 2 : 0;
    p.binary(checked(p, wide(p.b) * wide(p.a)));
}

void multiply_quickly(P& p) {
    const bool negative = p.a >> 31 && p.settings.model & t8;
    p.cycles += negative ? top_bit(~p.a) + 1 : top_bit(p.a);
    p.binary(p.b * p.a);
}

void multiply_fractions(P& p) {
    if (p.a == P::most_neg && p.b == P::most_neg) {
        p.set_error();
        p.cycles += 3;
        p.binary(p.a);
        p.undefined |= 1;
        return;
    }
    const std::int64_t product = wide(p.b) * wide(p.a), whole = product >> 31, rest = product & 0x7FFFFFFF;
    const bool up = rest > 0x40000000 || (rest == 0x40000000 && (whole & 1));
    p.cycles += rest == 0 ? 3 : 0;
    p.binary(low(static_cast<std::uint64_t>(whole + up)));
}

void divide(P& p, bool remainder) {
    const std::int64_t dividend = wide(p.b), divisor = wide(p.a);
    if (divisor == 0 || (divisor == -1 && p.b == P::most_neg)) {
        p.set_error();
        p.binary(p.a);
        p.undefined |= 1;
        return;
    }
    p.binary(low(static_cast<std::uint64_t>(remainder ? dividend % divisor : dividend / divisor)));
}

void shift(P& p, bool left) {
    const Word places = p.a;
    p.cycles += std::min(places, Word{38});
    p.binary(places > 31 ? 0 : left ? p.b << places : p.b >> places);
}

void add_or_subtract_long(P& p, std::int64_t sign) { p.a = checked(p, wide(p.b) + sign * (wide(p.a) + (p.c & 1))); }

void unsigned_long_sum(P& p, bool subtract) {
    const std::uint64_t both = std::uint64_t{p.a} + (p.c & 1);
    const std::uint64_t result = subtract ? p.b - both : p.b + both;
    p.a = low(result);
    p.b = high(result) & 1;
}

void multiply_long(P& p) {
    const std::uint64_t product = std::uint64_t{p.b} * p.a + p.c;
    p.a = low(product);
    p.b = high(product);
}

void divide_long(P& p) {
    if (p.c >= p.a) {
        p.set_error();
        p.undefined |= 3;
        return;
    }
    const std::uint64_t dividend = pair(p.c, p.b);
    const Word divisor = p.a;
    p.a = low(dividend / divisor);
    p.b = low(dividend % divisor);
}

/// Returns the cycles of a long shift, without the 3 in the table.
unsigned long_shift_cycles(Word places) { return places < 32 ? places : std::min(places, Word{64}) - 31; }

void shift_long(P& p, bool left) {
    const Word places = p.a;
    const std::uint64_t value = pair(p.c, p.b);
    const std::uint64_t result = places > 63 ? 0 : left ? value << places : value >> places;
    p.cycles += long_shift_cycles(places);
    p.a = low(result);
    p.b = high(result);
}

void normalise(P& p) {
    const std::uint64_t value = pair(p.b, p.a);
    p.c = static_cast<Word>(std::countl_zero(value));
    p.undefined &= 3;
    p.cycles += p.c == 64 ? 0 : p.c < 32 ? p.c + 2 : p.c - 29;
    if (value == 0)
        return;
    p.a = low(value << p.c);
    p.b = high(value << p.c);
}

void sign_of_part(P& p, bool check) {
    const Word sign = p.a, value = p.b;
    if (!check)
        return p.binary(wide(value) >= 0 && wide(value) < wide(sign) ? value : value - 2 * sign);
    if (wide(value) >= wide(sign) || wide(value) < wide(-sign))
        p.set_error();
    p.binary(value);
}

void extend(P& p) {
    p.c = p.b;
    p.b = p.a >> 31 ? 0xFFFFFFFF : 0;
    p.undefined = (p.undefined << 1 & 4) | (p.undefined & 1);
}

void check_single(P& p) {
    if (p.b != (p.a >> 31 ? 0xFFFFFFFF : 0))
        p.set_error();
    p.b = p.c;
    p.undefined = (p.undefined & 5) | (p.undefined >> 1 & 2);
}

void check_below(P& p, bool from_zero) {
    const Word limit = p.a, value = p.b;
    if (from_zero ? value >= limit : value == 0 || value > limit)
        p.set_error();
    p.binary(value);
}

void count_words(P& p) {
    p.c = p.b;
    p.b = p.a & 3;
    p.a = low(static_cast<std::uint64_t>(wide(p.a) >> 2));
    p.undefined = (p.undefined << 1 & 4) | (p.undefined & 1);
}

void cyclic_redundancy(P& p, int steps) {
    for (int i = 0; i < steps; ++i) {
        const bool out = p.b >> 31;
        p.b = p.b << 1 | p.a >> 31;
        p.a <<= 1;
        p.b ^= out ? p.c : 0;
    }
    p.a = p.b;
    p.b = p.c;
    p.c = p.a;
}

Word reversed(Word word, Word bits) {
    Word result = 0;
    for (Word i = 0; i < bits; ++i)
        result |= (word >> i & 1) << (bits - 1 - i);
    return result;
}

void reverse_some(P& p) {
    const Word bits = std::min(p.a, Word{32});
    p.cycles += bits;
    p.binary(reversed(p.b, bits));
}

void count_bits(P& p) {
    p.cycles += top_bit(p.a);
    p.binary(p.b + static_cast<Word>(std::popcount(p.a)));
}

void store_byte(P& p) {
    p.store_byte(p.a, static_cast<std::uint8_t>(p.b), true);
    p.pop_all(2);
}

void move(P& p) {
    p.copy(p.b, p.c, p.a);
    p.undefined = 7;
}

void pay_for_block(P& p) {
    p.pay_for_copy(p.c, p.b, p.a);
    p.cycles = p.rows * (p.cycles + 23);
    p.extra *= p.rows;
}

enum class Which { every, nonzero, zero };

void move_block(P& p, Which which) {
    for (Word row = 0; row < p.rows; ++row) {
        const Word target = p.b + row * p.target_stride, source = p.c + row * p.source_stride;
        std::vector<std::uint8_t> before(p.a), given(p.a);
        for (Word i = 0; i < p.a && target - P::most_neg + i < p.memory.size(); ++i)
            before[i] = p.memory[target - P::most_neg + i];
        p.copy(target, source, p.a);
        for (Word i = 0; i < p.a; ++i) {
            std::uint8_t& byte = p.memory[target - P::most_neg + i];
            if (which != Which::every && (which == Which::zero) != (byte == 0))
                byte = before[i];
        }
    }
    p.undefined = 7;
}

// Reals of the T414: A low word, B high word, C exponent.

void unpack_single(P& p) {
    const Word exponent = p.a >> 23 & 255, fraction = p.a & 0x7FFFFF;
    const Word kind = exponent == 255 ? (fraction ? 3 : 2) : (exponent || fraction ? 1 : 0);
    p.c = 4 * p.b + kind;
    p.b = kind == 1 && exponent == 0 ? 1 : exponent;
    p.a = fraction << 8 | (exponent != 0 && exponent != 255 ? P::most_neg : 0);
    p.undefined = 0;
}

void postnormalise(P& p) {
    const auto exponent = static_cast<std::int32_t>(p.local(0) - p.c);
    if (exponent < -31) {
        p.a = p.b = p.c = 0;
    } else if (exponent <= 0) {
        const std::uint64_t value = pair(p.b, p.a) >> (1 - exponent);
        p.a |= low(value);
        p.b = high(value);
        p.c = 0;
    } else {
        p.c = static_cast<Word>(std::min(exponent, 255));
    }
}

void round_single(P& p) {
    if (static_cast<std::int32_t>(p.c) >= 255) {
        p.a = 0x7F800000;
    } else {
        const Word cut = p.c << 23 | (p.b & 0x7FFFFF00) >> 8;
        const bool half = p.b & 0x80, more = (p.b & 0x7F) || p.a;
        p.a = cut + (half && (more || (cut & 1)));
    }
    p.undefined = 6;
}

void check_real(P& p) {
    if ((p.a >> 23 & 255) == 255)
        p.set_error();
}

constexpr PlainOperation table[] = {
    {0x00, "rev", 1, all,
     [](P& p) {
         std::swap(p.a, p.b), p.undefined = (p.undefined & 4) | (p.undefined & 1) << 1 | (p.undefined >> 1 & 1);
     }},
    {0x01, "lb", 5, all, [](P& p) { p.a = p.load_byte(p.a, true); }},
    {0x3B, "sb", 4, all, store_byte},
    {0x02, "bsub", 1, all, [](P& p) { p.binary(p.a + p.b); }},
    {0x0A, "wsub", 2, all, [](P& p) { p.binary(p.a + 4 * p.b); }},
    {0x81, "wsubdb", 3, newer, [](P& p) { p.binary(p.a + 8 * p.b); }},
    {0x34, "bcnt", 2, all, [](P& p) { p.a *= 4; }},
    {0x3F, "wcnt", 5, all, count_words},
    {0x05, "add", 1, all, [](P& p) { p.binary(checked(p, wide(p.b) + wide(p.a))); }},
    {0x0C, "sub", 1, all, [](P& p) { p.binary(checked(p, wide(p.b) - wide(p.a))); }},
    {0x52, "sum", 1, all, [](P& p) { p.binary(p.b + p.a); }},
    {0x04, "diff", 1, all, [](P& p) { p.binary(p.b - p.a); }},
    {0x53, "mul", 40, all, multiply},
    {0x08, "prod", 4, all, multiply_quickly},
    {0x72, "fmul", 35, all, multiply_fractions},
    {0x2C, "div", 39, all, [](P& p) { divide(p, false); }},
    {0x1F, "rem", 37, all, [](P& p) { divide(p, true); }},
    {0x09, "gt", 2, all, [](P& p) { p.binary(wide(p.b) > wide(p.a)); }},
    {0x46, "and", 1, all, [](P& p) { p.binary(p.b & p.a); }},
    {0x4B, "or", 1, all, [](P& p) { p.binary(p.b | p.a); }},
    {0x33, "xor", 1, all, [](P& p) { p.binary(p.b ^ p.a); }},
    {0x32, "not", 1, all, [](P& p) { p.a = ~p.a; }},
    {0x41, "shl", 2, all, [](P& p) { shift(p, true); }},
    {0x40, "shr", 2, all, [](P& p) { shift(p, false); }},
    {0x16, "ladd", 2, all, [](P& p) { add_or_subtract_long(p, 1); }},
    {0x38, "lsub", 2, all, [](P& p) { add_or_subtract_long(p, -1); }},
    {0x37, "lsum", 2, all, [](P& p) { unsigned_long_sum(p, false); }},
    {0x4F, "ldiff", 2, all, [](P& p) { unsigned_long_sum(p, true); }},
    {0x31, "lmul", 33, all, multiply_long},
    {0x1A, "ldiv", 35, all, divide_long},
    {0x36, "lshl", 3, all, [](P& p) { shift_long(p, true); }},
    {0x35, "lshr", 3, all, [](P& p) { shift_long(p, false); }},
    {0x19, "norm", 3, all, normalise},
    {0x3A, "xword", 4, all, [](P& p) { sign_of_part(p, false); }},
    {0x56, "cword", 5, all, [](P& p) { sign_of_part(p, true); }},
    {0x1D, "xdble", 2, all, extend},
    {0x4C, "csngl", 3, all, check_single},
    {0x42, "mint", 1, all, [](P& p) { p.push(P::most_neg); }},
    {0x5A, "dup", 1, newer,
     [](P& p) {
         const bool open = p.undefined & 1;
         p.push(p.a), p.undefined |= open;
     }},
    {0x13, "csub0", 2, all, [](P& p) { check_below(p, true); }},
    {0x4D, "ccnt1", 3, all, [](P& p) { check_below(p, false); }},
    {0x63, "unpacksn", 15, t414 | t425 | t400, unpack_single},
    {0x6D, "roundsn", 12, t414 | t425 | t400, round_single},
    {0x6C, "postnormsn", 5, t414 | t425 | t400, postnormalise},
    {0x71, "ldinf", 1, t414 | t425 | t400, [](P& p) { p.push(0x7F800000); }},
    {0x73, "cflerr", 3, t414 | t425 | t400, check_real},
    {0x9C, "fptesterror", 2, t425 | t400, [](P& p) { p.push(1); }},
    {0x5B, "move2dinit", 8, newer,
     [](P& p) { p.rows = p.a, p.target_stride = p.b, p.source_stride = p.c, p.undefined = 7; }},
    {0x5C, "move2dall", 0, newer, [](P& p) { move_block(p, Which::every); }, When::at_end_unless_interrupted,
     pay_for_block},
    {0x5D, "move2dnonzero", 0, newer, [](P& p) { move_block(p, Which::nonzero); }, When::at_end_unless_interrupted,
     pay_for_block},
    {0x5E, "move2dzero", 0, newer, [](P& p) { move_block(p, Which::zero); }, When::at_end_unless_interrupted,
     pay_for_block},
    {0x74, "crcword", 35, newer, [](P& p) { cyclic_redundancy(p, 32); }},
    {0x75, "crcbyte", 11, newer, [](P& p) { cyclic_redundancy(p, 8); }},
    {0x76, "bitcnt", 2, newer, count_bits},
    {0x77, "bitrevword", 36, newer, [](P& p) { p.a = reversed(p.a, 32); }},
    {0x78, "bitrevnbits", 4, newer, reverse_some},
    {0x4A, "move", 8, all, move, When::at_end_unless_interrupted, [](P& p) { p.pay_for_copy(p.c, p.b, p.a); }},
    {0x20, "ret", 5, all, [](P& p) { p.iptr = p.local(0), p.wptr += 16; }},
    {0x06, "gcall", 4, all, [](P& p) { std::swap(p.a, p.iptr); }},
    {0x3C, "gajw", 2, all, [](P& p) { std::swap(p.a, p.wptr), p.wptr &= ~3U; }},
    {0x1B, "ldpi", 2, all, [](P& p) { p.a += p.iptr; }},
    {0x10, "seterr", 1, all, [](P& p) { p.set_error(); }},
    {0x29, "testerr", 2, all,
     [](P& p) { p.cycles += p.error[p.priority], p.push(!p.error[p.priority]), p.error[p.priority] = false; }},
    {0x57, "clrhalterr", 1, all, [](P& p) { p.halt_on_error = false; }},
    {0x58, "sethalterr", 1, all, [](P& p) { p.halt_on_error = true; }},
    {0x59, "testhalterr", 2, all, [](P& p) { p.push(p.halt_on_error); }},
    {0x2A, "testpranal", 2, all, [](P& p) { p.push(p.analysed); }},
    {0x17C, "lddevid", 1, newer,
     [](P& p) {
         p.push(p.settings.model == t805 ? 10 : p.settings.model == t400 ? 50 : 0);
     }},
    {0x79, "pop", 1, debugged, [](P& p) { p.pop(); }},
    {0x7E, "ldmemstartval", 1, debugged, [](P& p) { p.push(p.mem_start()); }},
    {0xB1, "break", 9, debugged, [](P& p) { p.stop("break"); }, When::at_end},
    {0xB2, "clrj0break", 1, debugged, [](P& p) { p.j0_break = false; }},
    {0xB3, "setj0break", 1, debugged, [](P& p) { p.j0_break = true; }},
    {0xB4, "testj0break", 2, debugged, [](P& p) { p.push(p.j0_break); }},
};

} // namespace plain_integers

const std::span<const PlainOperation> plain_integer_operations = plain_integers::table;

} // namespace placedpar::test
