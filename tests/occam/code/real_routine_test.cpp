// Compares the routines for reals, on a T414, with the floating-point unit of a T800 and with the host's arithmetic:
// all pairs of special values, and random ones.

#include "executed.hpp"
#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr std::size_t pairs = 5'000;

/// An operation on x and y, two reals of a type T, or on the integers i and j with the same bits.
struct RealOperation {
    std::string_view expression;
    std::string_view result = ""; ///< its type; "": that of x
};

constexpr std::array operations = {
    RealOperation{"x + y"},
    RealOperation{"x - y"},
    RealOperation{"x * y"},
    RealOperation{"x / y"},
    RealOperation{"x \\ y"},
    RealOperation{"- x"},
    RealOperation{"(x + y) * (x - y)"},
    RealOperation{"x = y", "BOOL"},
    RealOperation{"x <> y", "BOOL"},
    RealOperation{"x < y", "BOOL"},
    RealOperation{"x > y", "BOOL"},
    RealOperation{"x <= y", "BOOL"},
    RealOperation{"x >= y", "BOOL"},
    RealOperation{"INT ROUND x", "INT"},
    RealOperation{"INT TRUNC x", "INT"},
    RealOperation{"INT16 ROUND x", "INT16"},
    RealOperation{"INT64 ROUND x", "INT64"},
    RealOperation{"INT64 TRUNC x", "INT64"},
    RealOperation{"T ROUND i"},
    RealOperation{"T TRUNC i"},
    RealOperation{"T ROUND (INT i)"},
    RealOperation{"T TRUNC (INT i)"},
    RealOperation{"$SQRT (x)"},
    RealOperation{"$ABS (x)"},
    RealOperation{"$MINUSX (x)"},
    RealOperation{"$MULBY2 (x)"},
    RealOperation{"$DIVBY2 (x)"},
    RealOperation{"$FPINT (x)"},
    RealOperation{"$COPYSIGN (x, y)"},
    RealOperation{"$ISNAN (x)", "BOOL"},
    RealOperation{"$NOTFINITE (x)", "BOOL"},
    RealOperation{"$ORDERED (x, y)", "BOOL"},
    RealOperation{"TREM (x, y)"},
    RealOperation{"TEQ (x, y)", "BOOL"},
    RealOperation{"TGT (x, y)", "BOOL"},
};
constexpr std::array of_real32 = {RealOperation{"REAL64 x", "REAL64"}};
constexpr std::array of_real64 = {RealOperation{"REAL32 ROUND x", "REAL32"}, RealOperation{"REAL32 TRUNC x", "REAL32"},
                                  RealOperation{"REAL32 ROUND i", "REAL32"}, RealOperation{"REAL32 TRUNC i", "REAL32"}};

std::string with_type(std::string_view text, bool is_double) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_type = text[i] == 'T' && (i == 0 || text[i - 1] == ' ') &&
                             (text.substr(i, 2) == "T " || text.substr(i, 4) == "TREM" || text.substr(i, 3) == "TEQ" ||
                              text.substr(i, 3) == "TGT");
        if (is_type)
            result += is_double ? "REAL64" : "REAL32";
        else if (text[i] == '$')
            result += is_double ? "D" : "";
        else
            result += text[i];
    }
    return result;
}

/// Makes reals that are at the edges of what an operation can do, and others.
class RealMaker {
public:
    RealMaker(std::uint64_t seed, bool is_double)
        : random_(seed, "reals"), fraction_bits_(is_double ? 52 : 23), exponents_(is_double ? 2047 : 255) {}

    /// Returns one of the special values, or nothing if there are no more.
    std::vector<std::uint64_t> special() const {
        const std::uint64_t fraction = (std::uint64_t{1} << fraction_bits_) - 1;
        std::vector<std::uint64_t> all;
        const std::uint64_t bias = exponents_ / 2;
        for (const std::uint64_t exponent :
             {std::uint64_t{0}, std::uint64_t{1}, bias - 1, bias, bias + 31, exponents_ - 1, exponents_})
            for (const std::uint64_t low : {std::uint64_t{0}, std::uint64_t{1}, fraction / 2 + 1, fraction})
                for (const bool negative : {false, true})
                    all.push_back(with_sign(exponent << fraction_bits_ | low, negative));
        return all;
    }
    std::uint64_t any() {
        const std::uint64_t fraction = raw() & ((std::uint64_t{1} << fraction_bits_) - 1);
        return with_sign(random_.below(static_cast<std::uint32_t>(exponents_ + 1)) *
                                 (std::uint64_t{1} << fraction_bits_) |
                             shortened(fraction),
                         random_.chance(0.5));
    }
    /// Returns a real whose exponent is near that of another.
    std::uint64_t near(std::uint64_t other) {
        const std::uint64_t exponent = other >> fraction_bits_ & exponents_;
        const std::uint64_t moved =
            std::min(exponents_, exponent + random_.below(static_cast<std::uint32_t>(2 * fraction_bits_)) -
                                     std::min<std::uint64_t>(exponent, static_cast<std::uint64_t>(fraction_bits_)));
        return (any() & ~(exponents_ << fraction_bits_)) | moved << fraction_bits_;
    }
    /// Returns a number between 2^-3 and 2^66.
    std::uint64_t moderate() {
        return (any() & ~(exponents_ << fraction_bits_)) | (exponents_ / 2 - 3 + random_.below(70)) << fraction_bits_;
    }
    bool chance(double share) { return random_.chance(share); }

private:
    std::uint64_t raw() { return std::uint64_t{random_.below(~0U)} << 32 | random_.below(~0U); }
    std::uint64_t with_sign(std::uint64_t bits, bool negative) const {
        return bits | std::uint64_t{negative} << (fraction_bits_ == 52 ? 63 : 31);
    }
    /// Leaves only some leading bits, so that there are ties, or few bits but the leading ones.
    std::uint64_t shortened(std::uint64_t fraction) {
        const auto places = random_.below(static_cast<std::uint32_t>(fraction_bits_ + 1));
        return random_.chance(0.4) ? fraction >> places << places : fraction;
    }

    RandomStream random_;
    int fraction_bits_;
    std::uint64_t exponents_;
};

/// Returns pairs of reals, four words for each.
std::vector<std::int32_t> pairs_of(std::uint64_t seed, bool is_double) {
    RealMaker maker(seed, is_double);
    std::vector<std::int32_t> words;
    const auto add = [&](std::uint64_t bits) {
        words.push_back(static_cast<std::int32_t>(bits));
        words.push_back(static_cast<std::int32_t>(bits >> 32));
    };
    const auto special = maker.special();
    for (std::size_t i = 0; i < pairs; ++i) {
        const std::size_t first = i / special.size();
        if (first < special.size()) {
            add(special[first]);
            add(special[i % special.size()]);
            continue;
        }
        const std::uint64_t x = maker.chance(0.3) ? maker.moderate() : maker.any();
        add(x);
        add(maker.chance(0.1) ? maker.any() : maker.chance(0.1) ? x ^ 1 : maker.near(x));
    }
    return words;
}

/// Returns a program that starts a process for each pair. It stores two words of the result, and then 1.
std::string program_of(const RealOperation& operation, bool is_double) {
    const std::string real = is_double ? "REAL64" : "REAL32";
    const std::string result = operation.result.empty() ? real : std::string(operation.result);
    const std::string convert =
        result == "BOOL" || result == "INT16" ? "VAL INT w IS INT v:\n" : "VAL INT w RETYPES v:\n";
    const bool is_wide = result.ends_with("64");
    const std::string store = is_wide ? "VAL [2]INT w RETYPES v:\nr[k][0], r[k][1], r[k][2] := w[0], w[1], 1\n"
                                      : convert + "r[k][0], r[k][2] := w, 1\n";
    return fmt::format(R"(VAL [{0}][4]INT given RETYPES [memory FROM 0 FOR {1}]:
[{0}][3]INT r RETYPES [memory FROM {1} FOR {2}]:
PAR k = 0 FOR {0}
  VAL {3} x RETYPES [given[k] FROM 0 FOR {4}]:
  VAL {3} y RETYPES [given[k] FROM 2 FOR {4}]:
  VAL {5} i RETYPES [given[k] FROM 0 FOR {4}]:
  {6} v:
  SEQ
    v := {7}
{8})",
                       pairs, 4 * pairs, 3 * pairs, real, is_double ? 2 : 1, is_double ? "INT64" : "INT", result,
                       with_type(operation.expression, is_double), indented(store, 4));
}

/// Executes an operation on all pairs. The results have three words for each: result and 1, or three zeros after an
/// error if errors stop processes.
std::vector<std::int32_t> results_of(const std::string& text, transputer::Model model, bool checks,
                                     const std::vector<std::int32_t>& given) {
    std::vector<std::int32_t> memory = given;
    memory.resize(7 * pairs);
    const Executed done = execute(text,
                                  {.model = model,
                                   .mode = checks ? occam::ErrorMode::stop : occam::ErrorMode::halt,
                                   .range_checks = checks,
                                   .run_time_checks = checks},
                                  "#OPTION \"AN\"\n", memory);
    CHECK(done.trouble == "");
    return {done.results.begin() + 4 * pairs, done.results.begin() + 7 * pairs};
}

template <typename T>
T real_at(const std::vector<std::int32_t>& words, std::size_t at) {
    const auto bits = static_cast<std::uint32_t>(words[at]) | std::uint64_t{static_cast<std::uint32_t>(words[at + 1])}
                                                                  << 32;
    if constexpr (sizeof(T) == 4)
        return std::bit_cast<T>(static_cast<std::uint32_t>(bits));
    else
        return std::bit_cast<T>(bits);
}

/// Returns what an operation gives on the host; nothing if the host does not have it, or if it is an error.
template <typename T>
std::optional<T> on_host(std::string_view expression, T x, T y) {
    const T result = expression == "x + y"       ? x + y
                     : expression == "x - y"     ? x - y
                     : expression == "x * y"     ? x * y
                     : expression == "x / y"     ? x / y
                     : expression == "x \\ y"    ? std::remainder(x, y)
                     : expression == "$SQRT (x)" ? std::sqrt(x)
                                                 : std::numeric_limits<T>::quiet_NaN();
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(result) ? std::optional(result) : std::nullopt;
}

template <typename T>
void compare(const RealOperation& operation, std::uint64_t seed) {
    constexpr bool is_double = sizeof(T) == 8;
    const std::vector<std::int32_t> given = pairs_of(seed, is_double);
    const std::string text = program_of(operation, is_double);
    CAPTURE(with_type(operation.expression, is_double));
    for (const bool checks : {true, false}) {
        CAPTURE(checks);
        if (!checks && operation.result.starts_with("INT"))
            continue; // what does not fit gives any value
        const auto by_routines = results_of(text, transputer::Model::t414, checks, given);
        const auto by_unit = results_of(text, transputer::Model::t800, checks, given);
        int failures = 0;
        for (std::size_t i = 0; i < pairs && failures < 3; ++i) {
            const std::span given_here(&given[4 * i], 4), here(&by_routines[3 * i], 3), there(&by_unit[3 * i], 3);
            INFO(fmt::format("x {:08x} {:08x} y {:08x} {:08x}: {:08x} {:08x} {}, T800 {:08x} {:08x} {}", given_here[1],
                             given_here[0], given_here[3], given_here[2], here[1], here[0], here[2], there[1], there[0],
                             there[2]));
            const bool equal = std::ranges::equal(here, there);
            CHECK(equal);
            failures += equal ? 0 : 1;
            const auto known = on_host<T>(operation.expression, real_at<T>(given, 4 * i), real_at<T>(given, 4 * i + 2));
            if (known && *known != 0)
                CHECK(real_at<T>(by_routines, 3 * i) == *known);
        }
    }
}

} // namespace

TEST_CASE("reals by routines are those of the floating-point unit, with its errors") {
    for (const std::uint64_t seed : seeds(1)) {
        INFO(replay(seed));
        for (const RealOperation& each : operations) {
            compare<float>(each, seed);
            compare<double>(each, seed);
        }
        for (const RealOperation& each : of_real32)
            compare<float>(each, seed);
        for (const RealOperation& each : of_real64)
            compare<double>(each, seed);
    }
}
