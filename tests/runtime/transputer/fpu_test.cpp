// Tests the floating-point unit as programs see it: its stack, flag, rounding mode, NaNs, and sequences of operations
// that compilers emit.

#include "runtime/transputer/fpu.hpp"

#include "runtime/random.hpp"
#include "tests/runtime/transputer/exact_reals.hpp"
#include "tests/runtime/transputer/real_values.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using namespace placedpar::transputer;

static_assert(std::is_trivially_copyable_v<Fpu>); // an interrupt saves it

namespace {

constexpr std::uint32_t infinity_32 = 0x7F800000, minus_32 = 0x80000000;
constexpr std::uint64_t infinity_64 = 0x7FF0'0000'0000'0000, minus_64 = 0x8000'0000'0000'0000;
constexpr std::uint32_t one = 0x3F800000, two = 0x40000000, three = 0x40400000;

Real single(std::uint32_t bits) { return {bits, Length::real32}; }

Fpu with_singles(std::uint32_t left, std::uint32_t right) {
    Fpu unit;
    unit.fpldnlsn(left);
    unit.fpldnlsn(right);
    return unit;
}

Fpu with_doubles(std::uint64_t left, std::uint64_t right) {
    Fpu unit;
    unit.fpldnldb(left);
    unit.fpldnldb(right);
    return unit;
}

struct Named {
    const char* name;
    std::function<void(Fpu&)> run;
};

/// Returns all operations except the four that set the mode.
std::vector<Named> operations() {
    return {{"fpldnlsn", [](Fpu& u) { u.fpldnlsn(one); }},
            {"fpldnldb", [](Fpu& u) { u.fpldnldb(one); }},
            {"fpldzerosn", [](Fpu& u) { u.fpldzerosn(); }},
            {"fpldzerodb", [](Fpu& u) { u.fpldzerodb(); }},
            {"fpldnladdsn", [](Fpu& u) { u.fpldnladdsn(one); }},
            {"fpldnladddb", [](Fpu& u) { u.fpldnladddb(one); }},
            {"fpldnlmulsn", [](Fpu& u) { u.fpldnlmulsn(one); }},
            {"fpldnlmuldb", [](Fpu& u) { u.fpldnlmuldb(one); }},
            {"fpstnlsn", [](Fpu& u) { u.fpstnlsn(); }},
            {"fpstnldb", [](Fpu& u) { u.fpstnldb(); }},
            {"fpstnli32", [](Fpu& u) { u.fpstnli32(); }},
            {"fprev", [](Fpu& u) { u.fprev(); }},
            {"fpdup", [](Fpu& u) { u.fpdup(); }},
            {"fpadd", [](Fpu& u) { u.fpadd(); }},
            {"fpsub", [](Fpu& u) { u.fpsub(); }},
            {"fpmul", [](Fpu& u) { u.fpmul(); }},
            {"fpdiv", [](Fpu& u) { u.fpdiv(); }},
            {"fpremfirst", [](Fpu& u) { u.fpremfirst(); }},
            {"fpremstep", [](Fpu& u) { u.fpremstep(); }},
            {"fpgt", [](Fpu& u) { u.fpgt(); }},
            {"fpeq", [](Fpu& u) { u.fpeq(); }},
            {"fpordered", [](Fpu& u) { u.fpordered(); }},
            {"fpnan", [](Fpu& u) { u.fpnan(); }},
            {"fpnotfinite", [](Fpu& u) { u.fpnotfinite(); }},
            {"fpchkerror", [](Fpu& u) { u.fpchkerror(); }},
            {"fptesterror", [](Fpu& u) { u.fptesterror(); }},
            {"fpuseterror", [](Fpu& u) { u.fpuseterror(); }},
            {"fpuclearerror", [](Fpu& u) { u.fpuclearerror(); }},
            {"fpi32tor32", [](Fpu& u) { u.fpi32tor32(1); }},
            {"fpi32tor64", [](Fpu& u) { u.fpi32tor64(1); }},
            {"fpb32tor64", [](Fpu& u) { u.fpb32tor64(1); }},
            {"fpint", [](Fpu& u) { u.fpint(); }},
            {"fprtoi32", [](Fpu& u) { u.fprtoi32(); }},
            {"fpuchki32", [](Fpu& u) { u.fpuchki32(); }},
            {"fpuchki64", [](Fpu& u) { u.fpuchki64(); }},
            {"fpur32tor64", [](Fpu& u) { u.fpur32tor64(); }},
            {"fpur64tor32", [](Fpu& u) { u.fpur64tor32(); }},
            {"fpunoround", [](Fpu& u) { u.fpunoround(); }},
            {"fpuabs", [](Fpu& u) { u.fpuabs(); }},
            {"fpuexpinc32", [](Fpu& u) { u.fpuexpinc32(); }},
            {"fpuexpdec32", [](Fpu& u) { u.fpuexpdec32(); }},
            {"fpumulby2", [](Fpu& u) { u.fpumulby2(); }},
            {"fpudivby2", [](Fpu& u) { u.fpudivby2(); }},
            {"fpusqrtfirst", [](Fpu& u) { u.fpusqrtfirst(); }},
            {"fpusqrtstep", [](Fpu& u) { u.fpusqrtstep(); }},
            {"fpusqrtlast", [](Fpu& u) { u.fpusqrtlast(); }}};
}

} // namespace

TEST_CASE("every operation but those that set it leaves the mode at nearest, and clears no error") {
    for (const Named& each : operations()) {
        CAPTURE(std::string(each.name));
        for (auto set : {&Fpu::fpurz, &Fpu::fpurp, &Fpu::fpurm}) {
            Fpu unit = with_singles(three, two);
            unit.fpuseterror();
            (unit.*set)();
            REQUIRE_NE(unit.rounding(), Rounding::nearest);
            each.run(unit);
            CHECK_EQ(unit.rounding(), Rounding::nearest);
            const std::string name = each.name;
            CHECK_EQ(unit.error(), name != "fptesterror" && name != "fpuclearerror");
        }
    }
    Fpu unit;
    unit.fpurz();
    unit.fpurn();
    CHECK_EQ(unit.rounding(), Rounding::nearest);
}

TEST_CASE("a mode is that of the next operation alone") {
    Fpu unit = with_singles(one, 0x33800001); // 1 + 2^-24 and a little more
    unit.fpurz();
    unit.fpldnladdsn(one);
    CHECK_EQ(unit.fa(), single(one));
    unit.fpldnladdsn(0x33800001);
    CHECK_EQ(unit.fa(), single(one + 1));
}

TEST_CASE("loads push, stores and comparisons pop, and what a pop leaves in FC stays") {
    Fpu unit;
    unit.fpldnlsn(one);
    unit.fpldnldb(minus_64);
    unit.fpldnlsn(three);
    unit.fpldnlsn(two);
    CHECK_EQ(unit.fa(), single(two));
    CHECK_EQ(unit.fb(), single(three));
    CHECK_EQ(unit.fc(), Real{minus_64, Length::real64});
    CHECK_EQ(unit.fpstnlsn(), two);
    CHECK_EQ(unit.fpstnlsn(), three);
    CHECK_EQ(unit.fpstnldb(), minus_64);
    CHECK_EQ(unit.fc(), Real{minus_64, Length::real64});

    unit.fpldzerodb();
    unit.fpldzerosn();
    unit.fpdup();
    CHECK_EQ(unit.fa(), single(0));
    CHECK_EQ(unit.fb(), single(0));
    CHECK_EQ(unit.fc(), Real{0, Length::real64});
    unit.fpldnlsn(one);
    unit.fprev();
    CHECK_EQ(unit.fa(), single(0));
    CHECK_EQ(unit.fb(), single(one));
    CHECK_EQ(unit.fc(), single(0));
}

TEST_CASE("arithmetic with memory is a load and an operation, without a push") {
    for (Length length : all_lengths)
        for (Real left : special_reals(length))
            for (Real right : special_reals(length)) {
                const bool small = length == Length::real32;
                const auto word = std::uint32_t(right.bits);
                Fpu loaded = small ? with_singles(three, std::uint32_t(left.bits)) : with_doubles(three, left.bits);
                for (auto operation : {&Fpu::fpadd, &Fpu::fpmul}) {
                    Fpu two_steps = loaded, one_step = loaded;
                    small ? two_steps.fpldnlsn(word) : two_steps.fpldnldb(right.bits);
                    two_steps.fpurp();
                    (two_steps.*operation)();
                    one_step.fpurp();
                    if (operation == &Fpu::fpadd)
                        small ? one_step.fpldnladdsn(word) : one_step.fpldnladddb(right.bits);
                    else
                        small ? one_step.fpldnlmulsn(word) : one_step.fpldnlmuldb(right.bits);
                    CHECK_EQ(one_step.fa(), two_steps.fa());
                    CHECK_EQ(one_step.fb(), loaded.fb());
                    CHECK_EQ(one_step.error(), two_steps.error());
                }
            }
}

TEST_CASE("invalid operations give the NaNs that INMOS published, and set the error") {
    struct Row {
        void (Fpu::*operation)();
        std::uint32_t left, right, nan;
        std::uint64_t nan_64;
    };
    const auto remainder = [](Fpu& unit) { unit.fpremfirst(); };
    const auto doubled = [](std::uint32_t single) { // zeros, infinities and -1
        const std::uint64_t sign = single & minus_32 ? minus_64 : 0;
        const std::uint32_t magnitude = single & ~minus_32;
        return sign | (magnitude == infinity_32 ? infinity_64 : magnitude == one ? 0x3FF0'0000'0000'0000 : 0);
    };
    for (const Row& row :
         {Row{&Fpu::fpdiv, 0, minus_32, 0x7FC00000, 0x7FF8'0000'0000'0000},
          Row{&Fpu::fpdiv, minus_32 | infinity_32, infinity_32, 0x7FA00000, 0x7FF4'0000'0000'0000},
          Row{&Fpu::fpmul, minus_32, infinity_32, 0x7F900000, 0x7FF2'0000'0000'0000},
          Row{&Fpu::fpmul, infinity_32, 0, 0x7F900000, 0x7FF2'0000'0000'0000},
          Row{&Fpu::fpadd, infinity_32, minus_32 | infinity_32, 0x7F880000, 0x7FF1'0000'0000'0000},
          Row{&Fpu::fpsub, minus_32 | infinity_32, minus_32 | infinity_32, 0x7F880000, 0x7FF1'0000'0000'0000},
          Row{&Fpu::fpusqrtfirst, 0, minus_32 | one, 0x7F840000, 0x7FF0'8000'0000'0000},
          Row{&Fpu::fpusqrtfirst, 0, minus_32 | infinity_32, 0x7F840000, 0x7FF0'8000'0000'0000},
          Row{nullptr, infinity_32, one, 0x7F804000, 0x7FF0'0800'0000'0000},
          Row{nullptr, one, minus_32, 0x7F802000, 0x7FF0'0400'0000'0000}}) {
        Fpu unit = with_singles(row.left, row.right), wide = with_doubles(doubled(row.left), doubled(row.right));
        for (Fpu* each : {&unit, &wide})
            row.operation ? (each->*row.operation)() : remainder(*each);
        CHECK_EQ(unit.fa(), single(row.nan));
        CHECK_EQ(wide.fa(), Real{row.nan_64, Length::real64});
        CHECK(unit.error());
        CHECK(wide.error());
    }
    Fpu shortened = with_doubles(0, infinity_64 | 5);
    shortened.fpur64tor32();
    CHECK_EQ(shortened.fa(), single(0x7F820000));
}

TEST_CASE("underflow and inexact results set no error; overflow does, also where the result is finite") {
    Fpu tiny = with_singles(1, 0x3F000000), inexact = with_singles(one, three), great = with_singles(0x7F7FFFFF, two);
    tiny.fpmul();
    inexact.fpdiv();
    CHECK_EQ(tiny.fa(), single(0));
    CHECK_FALSE(tiny.error());
    CHECK_FALSE(inexact.error());
    great.fpurz();
    great.fpmul();
    CHECK_EQ(great.fa(), single(0x7F7FFFFF));
    CHECK(great.error());
}

TEST_CASE("fptesterror tells that there was no error, and clears it; fpchkerror keeps it") {
    Fpu unit;
    CHECK(unit.fptesterror());
    CHECK_FALSE(unit.fpchkerror());
    unit.fpuseterror();
    CHECK(unit.fpchkerror());
    CHECK(unit.fpchkerror());
    CHECK_FALSE(unit.fptesterror());
    CHECK(unit.fptesterror());
    unit.fpuseterror();
    unit.fpuclearerror();
    CHECK_FALSE(unit.fpchkerror());
}

TEST_CASE("a copy of the unit is what an interrupt restores") {
    Fpu unit = with_singles(one, three);
    unit.fpurp();
    const Fpu saved = unit;
    unit.fpuseterror();
    unit.fpdiv();
    CHECK_FALSE(unit == saved);
    unit = saved;
    unit.fpdiv();
    CHECK_EQ(unit.fa(), single(0x3EAAAAAB));
}

TEST_CASE("the compilers' loop of a remainder ends at the first step and leaves the quotient in FB") {
    Fpu unit = with_singles(0x41B80000, 0x40A00000); // 23, 5
    std::uint32_t a = unit.fpremfirst();
    const bool jumps_to_done = std::uint32_t(a == 0) == 0; // eqc 0; cj done
    CHECK(jumps_to_done);
    CHECK_EQ(unit.fa(), single(0xC0000000)); // -2: the nearest quotient is 5
    CHECK_EQ(unit.fb(), single(0x40A00000));
    const Fpu before = unit;
    a = unit.fpremstep();
    CHECK_NE(a, 0); // so cj falls through the end of the loop
    CHECK_EQ(unit, before);
}

TEST_CASE("programs store a long integer as two words") {
    RandomStream random(3, "long integers");
    for (int i = 0; i < 1'000; ++i) {
        const auto drawn = std::int64_t(std::uint64_t(random()) << 32 | random()) >> random() % 64;
        const auto real_integer = double(drawn);
        if (std::fabs(real_integer) >= 0x1p63)
            continue;
        Fpu unit = with_doubles(0, real(real_integer).bits);
        unit.fpint();
        unit.fpdup();
        const std::uint32_t low = unit.fpstnli32();
        unit.fpuexpdec32();
        const std::uint32_t high = unit.fpstnli32();
        CHECK_EQ(std::int64_t(std::uint64_t(high) << 32 | low), std::int64_t(real_integer));
    }
}

TEST_CASE("fpunoround keeps the fraction for the next operation, and a store cuts it") {
    for (auto [wide, narrow] : {std::pair{0x3FF8'0000'3FFF'FFFF, 0x3FC00001U},
                                {0xBFF0'0000'1FFF'FFFF, minus_32 | one},
                                {0x8000'0000'0000'0000, minus_32},
                                {0x43E0'0000'0000'0000, 0x5F000000U}}) {
        Fpu unit = with_doubles(0, std::uint64_t(wide));
        unit.fpunoround();
        CHECK_FALSE(unit.error());
        Fpu product = unit;
        product.fpldnlmulsn(0x3F800000);
        CHECK_EQ(product.fa(), single(std::bit_cast<std::uint32_t>(float(std::bit_cast<double>(std::uint64_t(wide))))));
        CHECK_EQ(unit.fpstnlsn(), narrow);
    }
}

TEST_CASE("the code of INMOS's compiler converts an INT64 to a REAL32 with one rounding") {
    RandomStream random(1, "long integers");
    for (int i = 0; i < 20'000; ++i) {
        const std::uint64_t raw = std::uint64_t(random.below(~0U)) << 32 | random.below(~0U);
        const auto places = random.below(64), blank = random.below(64);
        const auto number = std::int64_t(raw) >> places >> blank << blank | std::int64_t(random.below(2));
        for (const bool cuts : {false, true}) {
            Fpu unit;
            unit.fpb32tor64(std::uint32_t(number));
            unit.fpunoround();
            unit.fpi32tor64(std::uint32_t(std::uint64_t(number) >> 32));
            unit.fpuexpinc32();
            unit.fpunoround();
            if (cuts)
                unit.fpurz();
            unit.fpadd();
            std::fesetround(cuts ? FE_TOWARDZERO : FE_TONEAREST);
            const volatile auto expected = float(number);
            std::fesetround(FE_TONEAREST);
            CHECK_EQ(unit.fa(), single(std::bit_cast<std::uint32_t>(float(expected))));
            CHECK_FALSE(unit.error());
        }
    }
}
