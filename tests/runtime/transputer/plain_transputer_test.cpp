// Tests of the plain transputer by answers that are known from elsewhere.

#include "edges.hpp"
#include "plain_transputer.hpp"
#include "runtime/random.hpp"
#include "runtime/transputer/assembler.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>

using namespace placedpar::test;
using placedpar::transputer::assemble;
using placedpar::transputer::Assembly;

namespace {

using Word = PlainTransputer::Word;

/// A transputer with a program at MemStart and the workspace at label `w`, or else 1 Kbyte further.
struct PlainRun {
    explicit PlainRun(const std::string& source, PlainSettings settings = {}) : t(settings) {
        program = assemble(source, t.mem_start());
        t.poke(t.iptr, program.bytes);
        if (program.labels.contains("w"))
            t.wptr = program["w"];
        for (const Word head : {0U, 4U})
            t.poke(PlainTransputer::timer_heads + head, PlainTransputer::not_process);
    }
    std::uint64_t cycles_to(std::string_view label) {
        const auto half = t.run(program[label]);
        REQUIRE(t.stopped == "");
        return half / 2;
    }
    void to_end() { t.run(0); }
    Word word(std::string_view label) const { return t.peek(program[label]); }

    PlainTransputer t;
    Assembly program;
};

struct PlainOutcome {
    Word a, b, c;
    bool error;
    std::uint64_t cycles;
};

/// Executes one operation.
PlainOutcome result_of(const char* name, Word a, Word b, Word c, PlainModel model = t800) {
    PlainRun run(name, {.model = model, .memory = 8192});
    run.t.a = a;
    run.t.b = b;
    run.t.c = c;
    const auto half_cycles = run.t.step();
    REQUIRE(run.t.stopped == "");
    return {run.t.a, run.t.b, run.t.c, run.t.error[1], half_cycles / 2};
}

__extension__ typedef __int128 Wide;
Wide signed_of(Word word) { return static_cast<std::int32_t>(word); }
Wide signed_of(Word upper, Word lower) { return static_cast<std::int64_t>(std::uint64_t{upper} << 32 | lower); }
bool fits(Wide value) { return value >= INT32_MIN && value <= INT32_MAX; }
Word low_word(Wide value) { return static_cast<Word>(value); }

/// COMMSTIME as INMOS's compiler makes it.
const std::string comstime = R"(
           mint; stl 3; mint; stl 5; mint; stl 4; mint; stl 2      -- channels a, b, c, d
           ldc delta - one; ldlp -8; startp
      one: ldc succ - two; ldlp -18; startp
      two: ldc consumer - three; ldlp -31; startp
    three: ajw -2; ldlp 5; ldc 0; outword                          -- a ! 0
   prefix: ldlp 1; ldlp 7; ldc 4; in; ldlp 5; ldl 1; outword       -- b ? x; a ! x
           j prefix
    delta: ldlp 2; ldlp 11; ldc 4; in                              -- a ? x
           ldc 2; stl 1; ldc joined - next; ldpi                   -- PAR
     next: stl 0; ldc other - started; ldlp -5; startp
  started: ajw -1; ldlp 13; ldl 3; outword; ldlp 1; endp           -- c ! x
    other: ldlp 15; ldl 7; outword; ldlp 5; endp                   -- d ! x
   joined: j delta
     succ: ldlp 1; ldlp 22; ldc 4; in; ldlp 23; ldl 1; adc 1; outword
           j succ                                                  -- c ? x; b ! x + 1
 consumer: ldc 0; stl 1; ldc 1000; stl 2
     each: ldlp 0; ldlp 33; ldc 4; in                              -- d ? x
      got: ldlp 1; ldc end - each; lend
      end: stopp
)";

} // namespace

TEST_CASE("plain arithmetic agrees with 128-bit arithmetic") {
    for (const Word a : edges())
        for (const Word b : edges()) {
            CAPTURE(a);
            CAPTURE(b);
            const Wide x = signed_of(b), y = signed_of(a);
            const auto check = [&](const char* name, Wide expected) {
                const auto outcome = result_of(name, a, b, 7);
                CHECK(outcome.a == low_word(expected));
                CHECK(outcome.b == 7);
                CHECK(outcome.error != fits(expected));
            };
            check("add", x + y);
            check("sub", x - y);
            check("mul", x * y);
            if (y != 0)
                CHECK(result_of("div", a, b, 7).error != fits(x / y));
            if (y != 0 && fits(x / y)) {
                check("div", x / y);
                check("rem", x % y);
            }
            CHECK(result_of("prod", a, b, 7).a == low_word(x * y));
            CHECK(result_of("gt", a, b, 7).a == (x > y));
            if (a != b || a != PlainTransputer::most_neg) {
                const Wide exact = x * y;
                const Wide result = signed_of(result_of("fmul", a, b, 7).a), miss = exact - (result << 31);
                const Wide half = Wide{1} << 30, distance = miss < 0 ? -miss : miss;
                CHECK((distance < half || (distance == half && result % 2 == 0)));
            }
        }
}

TEST_CASE("plain long arithmetic agrees with 128-bit arithmetic") {
    placedpar::RandomStream random(1, "long arithmetic");
    const auto values = edges();
    const auto any = [&] { return values[random.below(static_cast<std::uint32_t>(values.size()))]; };
    for (int i = 0; i < 20000; ++i) {
        const Word a = any(), b = any(), c = any();
        CAPTURE(a);
        CAPTURE(b);
        CAPTURE(c);
        const Wide carry = c & 1, x = b, y = a;
        const Wide sum = signed_of(b) + signed_of(a) + carry, difference = signed_of(b) - signed_of(a) - carry;
        CHECK(result_of("ladd", a, b, c).a == low_word(sum));
        CHECK(result_of("ladd", a, b, c).error != fits(sum));
        CHECK(result_of("lsub", a, b, c).a == low_word(difference));
        CHECK(result_of("lsub", a, b, c).error != fits(difference));
        const auto long_sum = result_of("lsum", a, b, c), long_difference = result_of("ldiff", a, b, c);
        CHECK((Wide{long_sum.b} << 32) + long_sum.a == x + y + carry);
        CHECK(Wide{long_difference.a} - (Wide{long_difference.b} << 32) == x - y - carry);
        const auto product = result_of("lmul", a, b, c);
        CHECK((Wide{product.b} << 32) + product.a == x * y + c);
        const auto quotient = result_of("ldiv", a, b, c);
        CHECK(quotient.error == (c >= a));
        if (c < a) {
            CHECK(Wide{quotient.a} * a + quotient.b == (Wide{c} << 32) + b);
            CHECK(quotient.b < a);
        }
        const Word places = a % 70;
        const Wide value = (Wide{c} << 32) + b;
        const auto left = result_of("lshl", places, b, c), right = result_of("lshr", places, b, c);
        CHECK((Wide{left.b} << 32) + left.a == (value << places) % (Wide{1} << 64));
        CHECK((Wide{right.b} << 32) + right.a == (value >> places));
        const auto normal = result_of("norm", a, b, c);
        if ((a | b) != 0) {
            CHECK(normal.b >= 0x80000000);
            CHECK((Wide{normal.b} << 32) + normal.a == (((x << 32) + y) << normal.c));
        }
        CHECK(normal.cycles == (normal.c == 64 ? 3 : normal.c < 32 ? normal.c + 5 : normal.c - 26) + 1);
        const auto twice = result_of("xdble", a, b, c);
        CHECK(signed_of(twice.b, twice.a) == signed_of(a));
        CHECK(result_of("csngl", a, b, c).error != fits(signed_of(b, a)));
    }
}

TEST_CASE("crcbyte and crcword give the known check values of \"123456789\"") {
    // CRC-32/BZIP2 and CRC-32/MPEG-2 shift to the left, as the instruction does. A sum over a message followed by 32
    // zero bits, whose first word is complemented, is theirs.
    const auto sum_of = [](bool by_words) {
        Word sum = 0;
        std::vector<std::uint8_t> message{'1', '2', '3', '4', '5', '6', '7', '8', '9', 0, 0, 0, 0};
        for (std::size_t i = 0; i < 4; ++i)
            message[i] ^= 255;
        for (std::size_t i = 0; i < message.size();) {
            const bool word = by_words && message.size() - i >= 4;
            Word data = 0;
            for (std::size_t k = 0; k < (word ? 4U : 1U); ++k)
                data |= Word{message[i++]} << (24 - 8 * k);
            sum = result_of(word ? "crcword" : "crcbyte", data, sum, 0x04C11DB7).a;
        }
        return sum;
    };
    CHECK(sum_of(false) == 0x0376E6E7); // CRC-32/MPEG-2
    CHECK(sum_of(true) == 0x0376E6E7);
    CHECK(result_of("crcword", 1, 2, 3).cycles == 36);
}

TEST_CASE("bit operations agree with the host's") {
    for (const Word a : edges())
        for (const Word b : edges()) {
            CHECK(result_of("bitcnt", a, b, 0).a == b + static_cast<Word>(std::popcount(a)));
            const Word once = result_of("bitrevword", a, b, 0).a;
            CHECK(result_of("bitrevword", once, b, 0).a == a);
            CHECK(std::countl_zero(once) == std::countr_zero(a));
            const Word places = a % 32;
            CHECK(result_of("shl", places, b, 0).a == (b << places));
            CHECK(result_of("shr", places, b, 0).a == (b >> places));
            CHECK(result_of("shr", places, b, 0).cycles == places + 3);
            CHECK(result_of("bitrevnbits", places, b, 0).a ==
                  (places ? result_of("bitrevword", b, 0, 0).a >> (32 - places) : 0));
        }
    CHECK(result_of("bitrevword", 0x00000001, 0, 0).a == 0x80000000);
    CHECK(result_of("bitrevword", 0x12345678, 0, 0).a == 0x1E6A2C48);
}

TEST_CASE("four processes of COMMSTIME take the cycles of the table") {
    // The code is as INMOS's compiler makes it. By the table, with a word for both ends of a communication, a loop
    // takes 282 cycles. Only the end that comes second pays 2 cycles for its word, which makes 8 cycles fewer.
    PlainRun run(comstime, {.memory = 8192});
    run.t.wptr = PlainTransputer::most_neg + 0x800;
    for (int warm_up = 0; warm_up < 3; ++warm_up) {
        run.cycles_to("got");
        run.t.step();
    }
    CHECK(run.cycles_to("got") + 1 == 282 - 8);
}

TEST_CASE("an alternation takes the first ready guard in the order of its disables") {
    // Processes at W - 30 and W - 60 output on the two channels, before the alternation if it gives way.
    const auto chosen = [](const std::string& before) {
        PlainRun run("mint; stl 10; mint; stl 11\n" + before + R"(
            alt; ldlp 10; ldc 1; enbc; ldlp 11; ldc 1; enbc; altwt
            ldlp 10; ldc 1; ldc one - end; disc; ldlp 11; ldc 1; ldc two - end; disc; altend
       end: stopp
       one: ldlp 1; ldlp 10; ldc 4; in; stopp
       two: ldlp 1; ldlp 11; ldc 4; in; stopp
       out: ldlp 40; ldc 1234; outword; stopp
      out2: ldlp 71; ldc 5678; outword; stopp
)");
        run.to_end();
        CHECK(run.t.stopped.find("deadlock") == 0);
        return run.t.peek(run.t.mem_start() + 0x404);
    };
    const std::string first = "ldc out - a; ldlp -30; startp\na:\n", second = "ldc out2 - b; ldlp -60; startp\nb:\n";
    const std::string give_way = "ldc on - t; ldlp -90; startp\nt: stopp\non: ajw 90\n";
    CHECK(chosen(first) == 1234);
    CHECK(chosen(second) == 5678);
    CHECK(chosen(first + second) == 1234);
    CHECK(chosen(second + first) == 1234);
    CHECK(chosen(second + first + give_way) == 1234);
    CHECK(chosen(second + give_way) == 5678);
}

TEST_CASE("tin waits until the clock is after the time") {
    for (const unsigned mhz : {20U, 25U})
        for (const bool high : {false, true}) {
            PlainRun run("ldc 10\nsttimer\nldc 12\nhere: tin\nwoken: ldtimer\nadc 0\nend: stopp", {.clock_mhz = mhz});
            run.t.priority = high ? 0 : 1;
            run.cycles_to("here");
            CHECK(run.t.clocks_since == 6);
            run.cycles_to("woken");
            CHECK(run.t.now == 6 + 2 * 3ULL * mhz * (high ? 1 : 64));
            run.cycles_to("end");
            CHECK(run.t.a == 13);
            CHECK(run.t.peek(run.t.wptr - 20) == 13);
        }
}

TEST_CASE("a high-priority process interrupts within 19 cycles, and the low one goes on unharmed") {
    PlainRun run(R"(
            ldc 0; sttimer; ldc high - here; ldpi   -- a process at W - 50 waits for time 9
      here: stl -51; ldlp -50; runp
     woken: ldc 7; ldc 8; ldc 9
      loop: j loop
      high: ldc 9; tin
        in: seterr; stopp
)");
    run.cycles_to("woken");
    run.cycles_to("in");
    const auto began = run.t.now / 2;
    CHECK(began >= 3 + 10 * 20 + 19); // clocks began at cycle 3
    CHECK(began < 3 + 10 * 20 + 19 + 4);
    const Word workspace = run.t.mem_start() + 0x400, loop = run.program["loop"];
    const std::array<Word, 5> saved{workspace | 1, loop, 9, 8, 7};
    for (Word i = 0; i < saved.size(); ++i)
        CHECK(run.t.peek(PlainTransputer::most_neg + 0x2C + 4 * i) == saved[i]);
    run.cycles_to("loop");
    CHECK(run.t.now / 2 == began + 2 + 12 + 17); // seterr and stopp have a prefix
    CHECK(run.t.a == 9);
    CHECK(run.t.c == 7);
    CHECK(!run.t.error[1]);
    CHECK(run.t.error[0]);
}

TEST_CASE("low-priority processes run for one to two timeslice periods") {
    PlainRun run("ldc two - here\nldlp -50\nstartp\nhere:\none: j one\ntwo: j two\n", {.clock_mhz = 5});
    const std::uint64_t period = 2 * 5120;
    const Word one = run.program["one"], two = run.program["two"];
    std::uint64_t began = 0;
    run.t.run(one);
    for (int i = 0; i < 6; ++i) {
        run.t.run(i % 2 ? one : two);
        CHECK(run.t.now - began > period);
        CHECK(run.t.now - began < 2 * period + 20);
        began = run.t.now;
    }
}

TEST_CASE("the integer unit goes on while the floating-point unit works") {
    const std::string load = "ldlp 0\nfpldnldb\nldlp 0\nfpldnldb\nwork: ";
    const std::string result = "\nldlp 2\nfpstnldb\nend: stopp";
    const auto cycles = [&](const std::string& between) {
        PlainRun run(load + "fpmul" + between + result);
        run.cycles_to("work");
        return run.cycles_to("end");
    };
    CHECK(cycles("") == 1 + 1 + 18 + 3); // prefix, rest of the load, product, store
    CHECK(cycles("\nmint\nmint\nmint") == cycles(""));
    CHECK(cycles("\nmint\nmul") > cycles(""));
}

TEST_CASE("memory outside the chip costs its cycles") {
    const std::string code = "ldl 0\nstl 1\nldl 2\nldl 3\nldl 4\nend:";
    for (const std::uint32_t memorycycles : {1U, 3U, 5U}) {
        PlainRun run(code, {.memorycycles = memorycycles});
        CHECK(run.cycles_to("end") == 9);
        run.t.iptr = run.t.mem_start();
        run.t.wptr = PlainTransputer::most_neg + 0x2000;
        CHECK(run.cycles_to("end") == 9 + 5 * (memorycycles - 1));
        const Word outside = PlainTransputer::most_neg + 0x3000;
        run.t.poke(outside, run.program.bytes);
        run.t.iptr = outside;
        CHECK(run.t.run(outside + 5) == 2 * (9 + 5 * (memorycycles - 1)) + 2 * (memorycycles - 1));
    }
}
