// Compares constants with an evaluator that uses integers of 128 bits and the reals of MPFR.

#include "tests/occam/check/check_text.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <mpfr.h>

#include <bit>
#include <cmath>
#include <functional>
#include <random>

using namespace placedpar;
using namespace placedpar::occam;

namespace {

__extension__ using Wide = __int128;

/// A random expression with its value; nothing where the machine would set its error flag.
struct Sample {
    std::string text;
    std::optional<Wide> integer = {}; ///< also of BOOL
    std::optional<double> real = {};
};

std::optional<Wide> in_range(Basic basic, Wide value) {
    if (basic == Basic::boolean || basic == Basic::byte)
        return value >= 0 && value <= (basic == Basic::byte ? 255 : 1) ? std::optional(value) : std::nullopt;
    const Wide limit = Wide{1} << (8 * bytes_of(basic) - 1);
    return value >= -limit && value < limit ? std::optional(value) : std::nullopt;
}

Wide lowest_bits(Basic basic, Wide value) {
    const Wide size = Wide{1} << (8 * bytes_of(basic));
    const Wide rest = ((value % size) + size) % size;
    return rest >= size / 2 ? rest - size : rest;
}

/// A number of MPFR with the precision of a type.
class ExactReal {
public:
    explicit ExactReal(Basic basic) : basic_(basic) { mpfr_init2(value, basic == Basic::real32 ? 24 : 53); }
    ExactReal(Basic basic, double given) : ExactReal(basic) { mpfr_set_d(value, given, MPFR_RNDN); }
    ExactReal(const ExactReal&) = delete;
    ExactReal& operator=(const ExactReal&) = delete;
    ~ExactReal() { mpfr_clear(value); }
    /// Returns the value if the type has it; the tests stay far from the smallest numbers.
    std::optional<double> result() const {
        const double given = mpfr_get_d(value, MPFR_RNDN);
        const bool fits = std::isfinite(given) && (basic_ == Basic::real64 || std::isfinite(static_cast<float>(given)));
        return fits ? std::optional(given) : std::nullopt;
    }
    mpfr_t value;

private:
    Basic basic_;
};

class Samples {
public:
    explicit Samples(std::uint64_t seed) : random_(seed) {}

    Sample sample(Basic basic, int depth) {
        if (is_real(basic))
            return real(basic, depth);
        if (basic == Basic::boolean)
            return truth(depth);
        return integer(basic, depth);
    }

private:
    std::size_t pick(std::size_t count) { return random_() % count; }

    Sample integer_literal(Basic basic) {
        const unsigned width = 8 * bytes_of(basic) - (basic == Basic::byte ? 0 : 1);
        std::uint64_t value = random_() >> (64 - width);
        if (pick(2) == 0)
            value %= 20;
        const bool is_negative = basic != Basic::byte && pick(3) == 0;
        const std::string text = std::to_string(value) + "(" + name_of(basic) + ")";
        return {is_negative ? "(- " + text + ")" : text, is_negative ? -Wide{value} : Wide{value}};
    }

    Sample converted_integer(Basic basic, int depth) {
        static constexpr std::array from = {Basic::byte,  Basic::integer, Basic::int16, Basic::int32,
                                            Basic::int64, Basic::real32,  Basic::real64};
        const Basic source = from[pick(basic == Basic::byte ? 5 : from.size())];
        const Sample operand = sample(source, depth - 1);
        if (!is_real(source))
            return {"(" + name_of(basic) + " " + operand.text + ")",
                    operand.integer ? in_range(basic, *operand.integer) : std::nullopt};
        const bool rounds = pick(2) == 0;
        Sample made{"(" + name_of(basic) + (rounds ? " ROUND " : " TRUNC ") + operand.text + ")"};
        const double whole = !operand.real ? 1e300 : rounds ? std::nearbyint(*operand.real) : std::trunc(*operand.real);
        if (std::abs(whole) < 1e30)
            made.integer = in_range(basic, static_cast<Wide>(whole));
        return made;
    }

    Sample integer(Basic basic, int depth) {
        if (depth == 0)
            return integer_literal(basic);
        if (basic == Basic::byte || pick(4) == 0)
            return converted_integer(basic, depth);
        if (pick(8) == 0) {
            const Sample operand = integer(basic, depth - 1);
            return {"(~ " + operand.text + ")", operand.integer ? std::optional(~*operand.integer) : std::nullopt};
        }
        static constexpr std::array names = {"+",     "-",   "*",   "/",  "\\", "PLUS", "MINUS",
                                             "TIMES", "/\\", "\\/", "><", "<<", ">>"};
        const std::size_t which = pick(names.size());
        const Sample left = integer(basic, depth - 1);
        const Sample right = which >= 11 ? integer_literal(Basic::byte) : integer(basic, depth - 1);
        const std::string second = which >= 11 ? "(INT " + right.text + ")" : right.text;
        Sample made{"(" + left.text + " " + names[which] + " " + second + ")"};
        if (left.integer && right.integer)
            made.integer = applied(which, basic, *left.integer, *right.integer);
        return made;
    }

    static std::optional<Wide> applied(std::size_t which, Basic basic, Wide a, Wide b) {
        const unsigned width = 8 * bytes_of(basic);
        const Wide pattern = a < 0 ? a + (Wide{1} << width) : a;
        switch (which) {
        case 0: return in_range(basic, a + b);
        case 1: return in_range(basic, a - b);
        case 2: return in_range(basic, a * b);
        case 3: return b == 0 ? std::nullopt : in_range(basic, a / b);
        case 4: return b == 0 ? std::nullopt : in_range(basic, a % b);
        case 5: return lowest_bits(basic, a + b);
        case 6: return lowest_bits(basic, a - b);
        case 7: return lowest_bits(basic, a * b);
        case 8: return a & b;
        case 9: return a | b;
        case 10: return a ^ b;
        case 11:
            return b > width ? std::nullopt
                             : std::optional(lowest_bits(basic, b == width ? 0 : pattern << static_cast<int>(b)));
        default:
            return b > width ? std::nullopt
                             : std::optional(lowest_bits(basic, b == width ? 0 : pattern >> static_cast<int>(b)));
        }
    }

    Sample real_literal(Basic basic) {
        std::string text = std::to_string(pick(100'000)) + "." + std::to_string(pick(1'000'000));
        if (pick(3) == 0)
            text += (pick(2) == 0 ? "E+" : "E-") + std::to_string(pick(12));
        ExactReal value(basic);
        mpfr_set_str(value.value, text.c_str(), 10, MPFR_RNDN);
        return {text + "(" + name_of(basic) + ")", std::nullopt, value.result()};
    }

    Sample real(Basic basic, int depth) {
        if (depth == 0)
            return real_literal(basic);
        if (pick(4) == 0)
            return converted_real(basic, depth);
        static constexpr std::array names = {"+", "-", "*", "/"};
        const std::size_t which = pick(names.size());
        const Sample left = real(basic, depth - 1), right = real(basic, depth - 1);
        Sample made{"(" + left.text + " " + names[which] + " " + right.text + ")"};
        if (!left.real || !right.real || (which == 3 && *right.real == 0))
            return made;
        static constexpr std::array operations = {mpfr_add, mpfr_sub, mpfr_mul, mpfr_div};
        ExactReal a(basic, *left.real), b(basic, *right.real), result(basic);
        operations[which](result.value, a.value, b.value, MPFR_RNDN);
        made.real = result.result();
        return made;
    }

    Sample converted_real(Basic basic, int depth) {
        static constexpr std::array from = {Basic::integer, Basic::int16, Basic::int64, Basic::real32, Basic::real64};
        const Basic source = from[pick(from.size())];
        const Sample operand = sample(source, depth - 1);
        const bool rounds = pick(2) == 0;
        Sample made{"(" + name_of(basic) + (rounds ? " ROUND " : " TRUNC ") + operand.text + ")"};
        ExactReal result(basic);
        const mpfr_rnd_t mode = rounds ? MPFR_RNDN : MPFR_RNDZ;
        if (operand.integer)
            mpfr_set_sj(result.value, static_cast<std::int64_t>(*operand.integer), mode);
        else if (operand.real)
            mpfr_set_d(result.value, *operand.real, mode);
        else
            return made;
        made.real = result.result();
        return made;
    }

    Sample truth(int depth) {
        static constexpr std::array types = {Basic::integer, Basic::int64, Basic::real32, Basic::byte};
        const Basic basic = types[pick(types.size())];
        const Sample left = sample(basic, depth - 1), right = pick(4) == 0 ? left : sample(basic, depth - 1);
        static constexpr std::array names = {"=", "<>", "<", ">", "<=", ">="};
        const std::size_t which = pick(names.size());
        Sample made{"(" + left.text + " " + names[which] + " " + right.text + ")"};
        const auto compare = [&](auto a, auto b) {
            const std::array answers = {a == b, a != b, a<b, a> b, a <= b, a >= b};
            made.integer = answers[which];
        };
        if (left.integer && right.integer)
            compare(*left.integer, *right.integer);
        else if (left.real && right.real)
            compare(*left.real, *right.real);
        return made;
    }

    std::mt19937_64 random_;
};

std::int64_t bits_of(const Sample& sample, Basic basic) {
    if (basic == Basic::real32)
        return std::bit_cast<std::uint32_t>(static_cast<float>(*sample.real));
    return basic == Basic::real64 ? std::bit_cast<std::int64_t>(*sample.real)
                                  : static_cast<std::int64_t>(*sample.integer);
}

} // namespace

TEST_CASE("constants of random expressions are those of an independent evaluator") {
    static constexpr std::array types = {Basic::boolean, Basic::byte,  Basic::integer, Basic::int16,
                                         Basic::int32,   Basic::int64, Basic::real32,  Basic::real64};
    std::size_t with_value = 0, without = 0;
    for (const std::uint64_t seed : test::seeds(6000)) {
        const Basic basic = types[seed % types.size()];
        const Sample sample = Samples(seed).sample(basic, 1 + static_cast<int>(seed / 8 % 4));
        const test::CheckedText checked = test::check_text("VAL r IS " + sample.text + ":\n");
        INFO(test::replay(seed) << "\n" << checked.messages);
        const bool has_value = sample.integer || sample.real;
        REQUIRE(checked.failed == !has_value);
        (has_value ? with_value : without) += 1;
        if (!has_value)
            continue;
        const Declaration& declared = test::declared(checked, "r");
        REQUIRE(declared.constant);
        CHECK(name_of(*declared.type) == name_of(basic));
        CHECK(declared.constant->bits == bits_of(sample, basic));
    }
    if (test::all_seeds()) {
        CHECK(with_value > 2000);
        CHECK(without > 500);
    }
}

TEST_CASE("constants of tables, strings, segments and types are as in memory") {
    const test::CheckedText checked = test::check_text(R"(VAL t IS [[1, -2], [#FF, 4]]:
VAL row IS t[1]:
VAL element IS t[1][0]:
VAL s IS "a*n*#41":
VAL part IS [s FROM 1 FOR 2]:
VAL size IS (SIZE t) + (SIZE s):
VAL INT pattern RETYPES 1.0(REAL32):
VAL [4]BYTE bytes RETYPES 258:
VAL wrapped IS (MOSTPOS INT16) PLUS 1(INT16):
VAL later IS (MOSTNEG INT) AFTER (MOSTPOS INT):
VAL nearest IS INT ROUND 2.5(REAL32):
DATA TYPE PAIR
  RECORD
    BYTE b:
    INT i:
:
VAL pair IS [1(BYTE), 7](PAIR):
VAL field IS pair[i]:
VAL bytes.in.pair IS (BYTESIN (PAIR)) + (OFFSETOF (PAIR, i)):
)");
    REQUIRE_MESSAGE(!checked.failed, checked.messages);
    const auto bits = [&](const char* name) { return test::declared(checked, name).constant->bits; };
    const auto bytes = [&](const char* name) { return *test::declared(checked, name).constant->bytes; };
    CHECK(bytes("t") == std::vector<std::uint8_t>{1, 0, 0, 0, 254, 255, 255, 255, 255, 0, 0, 0, 4, 0, 0, 0});
    CHECK(bytes("row") == std::vector<std::uint8_t>{255, 0, 0, 0, 4, 0, 0, 0});
    CHECK(bits("element") == 255);
    CHECK(bytes("s") == std::vector<std::uint8_t>{'a', '\n', 'A'});
    CHECK(bytes("part") == std::vector<std::uint8_t>{'\n', 'A'});
    CHECK(bits("size") == 5);
    CHECK(bits("pattern") == 0x3F800000);
    CHECK(bytes("bytes") == std::vector<std::uint8_t>{2, 1, 0, 0});
    CHECK(bits("wrapped") == -32768);
    CHECK(bits("later") == 1);
    CHECK(bits("nearest") == 2);
    CHECK(bytes("pair") == std::vector<std::uint8_t>{1, 0, 0, 0, 7, 0, 0, 0});
    CHECK(bits("field") == 7);
    CHECK(bits("bytes.in.pair") == 12);
}
