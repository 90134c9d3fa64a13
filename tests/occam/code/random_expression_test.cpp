// Compares random expressions of all types, executed on the emulated transputer, with an evaluator that computes with
// more digits and reports every error of the language.

#include "executed.hpp"
#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

using occam::Basic;

__extension__ using Integer = __int128;

/// The value of an expression: an integer or a BOOL, or a real.
struct ExactValue {
    Integer integer = 0;
    double real = 0;
};

/// A random expression: its text, and what it gives; nothing if it is an error.
struct RandomTerm {
    std::string text;
    std::optional<ExactValue> value;
    bool is_literal = false;
};

int bits_of(Basic type) { return static_cast<int>(8 * occam::bytes_of(type)); }

/// Returns a value modulo 2 to the power of `bits`. A value of 8 bits, a BYTE, has no sign.
Integer wrapped(Integer value, int bits) {
    const Integer range = Integer{1} << bits;
    value = ((value % range) + range) % range;
    return value >= range / 2 && bits > 8 ? value - range : value;
}

std::optional<ExactValue> fitting(Integer value, Basic type) {
    return wrapped(value, bits_of(type)) == value ? std::optional(ExactValue{value, 0}) : std::nullopt;
}

std::optional<ExactValue> real_of(double value, Basic type) {
    if (type == Basic::real32)
        value = static_cast<float>(value);
    return std::isfinite(value) ? std::optional(ExactValue{0, value}) : std::nullopt;
}

/// The variables_of_type of a type: two scalars, an array of four, and a function that returns its parameter.
constexpr int variables_of_type = 4;

class ExpressionMaker {
public:
    explicit ExpressionMaker(std::uint64_t seed) : random_(seed, "expressions") {
        for (std::size_t type = 0; type < values_.size(); ++type)
            for (ExactValue& each : values_[type])
                each = random_value(static_cast<Basic>(type));
        for (int i = 0; i < variables_of_type; ++i)
            indices_[static_cast<std::size_t>(i)] = i;
    }

    RandomTerm make(Basic type, int depth) {
        if (depth == 0 || random_.chance(0.15))
            return leaf(type);
        if (type == Basic::boolean)
            return condition(depth);
        if (random_.chance(0.1))
            return call(type, make(type, depth - 1));
        if (occam::is_real(type))
            return random_.chance(0.25) ? conversion_to_real(type, depth) : real_operation(type, depth);
        if (random_.chance(0.2))
            return conversion_to_integer(type, depth);
        return type != Basic::byte && random_.chance(0.2) ? unary(type, variable(type, depth - 1))
                                                          : integer_operation(type, depth);
    }

    /// Returns the literal of a value.
    static std::string literal(ExactValue value, Basic type) {
        if (type == Basic::boolean)
            return value.integer != 0 ? "TRUE" : "FALSE";
        if (occam::is_real(type)) {
            std::string digits = fmt::format("{:.17E}", std::abs(value.real));
            return fmt::format("({}{}({}))", std::signbit(value.real) ? "-" : "", digits, name_of(type));
        }
        const auto integer = static_cast<std::int64_t>(value.integer);
        return integer < 0
                   ? fmt::format("(-{}({}))", std::uint64_t{0} - static_cast<std::uint64_t>(integer), name_of(type))
                   : fmt::format("{}({})", integer, name_of(type));
    }

    const auto& values() const { return values_; }

private:
    ExactValue random_value(Basic type) {
        if (type == Basic::boolean)
            return {random_.below(2), 0};
        if (occam::is_real(type))
            return *real_of((static_cast<double>(random_.below(2001)) - 1000) / 8, type);
        const int bits = bits_of(type);
        const auto magnitude = static_cast<int>(random_.below(static_cast<std::uint32_t>(bits)));
        const auto raw = static_cast<std::int64_t>(std::uint64_t{random_.below(~0U)} << 32 | random_.below(~0U));
        return {type == Basic::byte ? raw & 255 : wrapped(raw >> (63 - magnitude), bits), 0};
    }

    RandomTerm leaf(Basic type) {
        const auto which = static_cast<std::size_t>(random_.below(variables_of_type));
        const ExactValue value = values_[static_cast<std::size_t>(type)][which];
        const std::string name = fmt::format("v.{}", name_of(type));
        switch (random_.below(4)) {
        case 0: {
            const ExactValue other = random_value(type);
            return {literal(other, type), other, true};
        }
        case 1: return {fmt::format("{}[{}]", name, which), value};
        case 2: return {fmt::format("{}[at[{}]]", name, which), value};
        default: return {fmt::format("x{}.{}", which, name_of(type)), value};
        }
    }

    static RandomTerm call(Basic type, RandomTerm argument) {
        argument.text = fmt::format("f.{} ({})", name_of(type), argument.text);
        argument.is_literal = false;
        return argument;
    }

    /// Returns an operand that is not a literal: the compiler refuses what is wrong in constant expressions.
    RandomTerm variable(Basic type, int depth) {
        RandomTerm term = make(type, depth);
        return term.is_literal ? call(type, std::move(term)) : term;
    }

    static RandomTerm unary(Basic type, const RandomTerm& operand) {
        RandomTerm result{fmt::format("(-{})", operand.text), std::nullopt};
        if (operand.value)
            result.value = fitting(-operand.value->integer, type);
        return result;
    }

    RandomTerm integer_operation(Basic type, int depth) {
        const RandomTerm left = variable(type, depth - 1);
        const int bits = bits_of(type);
        if (type != Basic::byte && random_.chance(0.15)) {
            const auto places = static_cast<int>(random_.below(static_cast<std::uint32_t>(bits) + 1));
            const bool by_variable = random_.chance(0.5), is_left = random_.chance(0.5);
            RandomTerm result{fmt::format("({} {} {})", left.text, is_left ? "<<" : ">>",
                                          by_variable ? fmt::format("f.INT ({})", places) : std::to_string(places)),
                              std::nullopt};
            if (left.value) {
                const Integer raw = left.value->integer & ((Integer{1} << bits) - 1);
                result.value = ExactValue{wrapped(is_left ? raw << places : raw >> places, bits), 0};
            }
            return result;
        }
        const RandomTerm right = variable(type, depth - 1);
        constexpr std::array operators = {"+", "-", "*", "/", "\\", "PLUS", "MINUS", "TIMES", "/\\", "\\/", "><"};
        auto which = random_.below(static_cast<std::uint32_t>(operators.size()));
        if (type == Basic::byte && which >= 5 && which <= 7)
            which -= 5; // a BYTE has no PLUS, MINUS and TIMES
        RandomTerm result{fmt::format("({} {} {})", left.text, operators[which], right.text), std::nullopt};
        if (!left.value || !right.value)
            return result;
        const Integer a = left.value->integer, b = right.value->integer;
        switch (which) {
        case 0: result.value = fitting(a + b, type); break;
        case 1: result.value = fitting(a - b, type); break;
        case 2: result.value = fitting(a * b, type); break;
        case 3: result.value = b == 0 ? std::nullopt : fitting(a / b, type); break;
        case 4: result.value = b == 0 || !fitting(a / b, type) ? std::nullopt : fitting(a % b, type); break;
        case 5: result.value = ExactValue{wrapped(a + b, bits), 0}; break;
        case 6: result.value = ExactValue{wrapped(a - b, bits), 0}; break;
        case 7: result.value = ExactValue{wrapped(wrapped(a * b, 128 - 1), bits), 0}; break;
        case 8: result.value = ExactValue{a & b, 0}; break;
        case 9: result.value = ExactValue{a | b, 0}; break;
        default: result.value = ExactValue{a ^ b, 0}; break;
        }
        return result;
    }

    RandomTerm real_operation(Basic type, int depth) {
        const RandomTerm left = variable(type, depth - 1), right = make(type, depth - 1);
        constexpr std::array operators = {"+", "-", "*", "/"};
        const auto which = random_.below(static_cast<std::uint32_t>(operators.size()));
        RandomTerm result{fmt::format("({} {} {})", left.text, operators[which], right.text), std::nullopt};
        if (!left.value || !right.value)
            return result;
        const double a = left.value->real, b = right.value->real;
        const auto computed = [&](auto x, auto y) -> double {
            return which == 0 ? x + y : which == 1 ? x - y : which == 2 ? x * y : x / y;
        };
        if (which == 3 && b == 0)
            return result;
        result.value = type == Basic::real32 ? real_of(computed(static_cast<float>(a), static_cast<float>(b)), type)
                                             : real_of(computed(a, b), type);
        return result;
    }

    RandomTerm conversion_to_real(Basic type, int depth) {
        const Basic from = random_.chance(0.5) ? Basic::integer : type == Basic::real32 ? Basic::real64 : Basic::real32;
        const RandomTerm operand = variable(from, depth - 1);
        const bool exact = from == Basic::real32;
        RandomTerm result{fmt::format("({} {}{})", name_of(type), exact ? "" : "ROUND ", operand.text), std::nullopt};
        if (operand.value)
            result.value = occam::is_real(from) ? real_of(operand.value->real, type)
                                                : real_of(static_cast<double>(operand.value->integer), type);
        return result;
    }

    RandomTerm conversion_to_integer(Basic type, int depth) {
        constexpr std::array from_types = {Basic::byte,  Basic::integer, Basic::int16, Basic::int32,
                                           Basic::int64, Basic::real32,  Basic::real64};
        const std::size_t count = from_types.size() - (type == Basic::byte ? 2 : 0); // a real cannot become a BYTE
        const Basic from = from_types[random_.below(static_cast<std::uint32_t>(count))];
        const RandomTerm operand = from == Basic::byte ? call(from, leaf(from)) : variable(from, depth - 1);
        const bool truncates = random_.chance(0.5);
        const char* const rounding = !occam::is_real(from) ? "" : truncates ? "TRUNC " : "ROUND ";
        RandomTerm result{fmt::format("({} {}{})", name_of(type), rounding, operand.text), std::nullopt};
        if (!operand.value)
            return result;
        if (!occam::is_real(from)) {
            result.value = fitting(operand.value->integer, type);
        } else if (const double rounded =
                       truncates ? std::trunc(operand.value->real) : std::nearbyint(operand.value->real);
                   std::abs(rounded) < 0x1p62) {
            result.value = fitting(static_cast<Integer>(rounded), type);
        }
        return result;
    }

    RandomTerm condition(int depth) {
        switch (random_.below(4)) {
        case 0: {
            RandomTerm operand = variable(Basic::boolean, depth - 1);
            operand.text = fmt::format("(NOT {})", operand.text);
            if (operand.value)
                operand.value->integer ^= 1;
            return operand;
        }
        case 1: {
            const RandomTerm left = variable(Basic::boolean, depth - 1), right = make(Basic::boolean, depth - 1);
            const bool is_and = random_.chance(0.5);
            RandomTerm result{fmt::format("({} {} {})", left.text, is_and ? "AND" : "OR", right.text), left.value};
            if (left.value && (left.value->integer != 0) == is_and)
                result.value = right.value;
            return result;
        }
        default: return comparison(depth);
        }
    }

    RandomTerm comparison(int depth) {
        constexpr std::array types = {Basic::byte,  Basic::integer, Basic::int16, Basic::int32,
                                      Basic::int64, Basic::real32,  Basic::real64};
        const Basic type = types[random_.below(static_cast<std::uint32_t>(types.size()))];
        const RandomTerm left = variable(type, depth - 1), right = make(type, depth - 1);
        constexpr std::array operators = {"=", "<>", "<", ">", "<=", ">="};
        const auto which = random_.below(static_cast<std::uint32_t>(operators.size()));
        RandomTerm result{fmt::format("({} {} {})", left.text, operators[which], right.text), std::nullopt};
        if (!left.value || !right.value)
            return result;
        const auto compared = [&](auto a, auto b) {
            return which == 0   ? a == b
                   : which == 1 ? a != b
                   : which == 2 ? a < b
                   : which == 3 ? a > b
                   : which == 4 ? a <= b
                                : a >= b;
        };
        result.value = ExactValue{occam::is_real(type) ? compared(left.value->real, right.value->real)
                                                       : compared(left.value->integer, right.value->integer),
                                  0};
        return result;
    }

    RandomStream random_;
    std::array<std::array<ExactValue, variables_of_type>, 8> values_;
    std::array<int, variables_of_type> indices_{};
};

constexpr std::array tested_types = {Basic::boolean, Basic::byte,  Basic::integer, Basic::int16,
                                     Basic::int32,   Basic::int64, Basic::real32,  Basic::real64};

/// Declares the variables_of_type of all types and gives them their values.
std::string with_variables(const ExpressionMaker& maker, const std::string& body) {
    std::string declarations = fmt::format("[{}]INT at:\n", variables_of_type), values = "SEQ\n";
    for (int i = 0; i < variables_of_type; ++i)
        values += fmt::format("  at[{0}] := {0}\n", i);
    for (std::size_t index = 0; index < 8; ++index) {
        const auto type = static_cast<Basic>(index);
        const std::string name = name_of(type);
        declarations += fmt::format("[{}]{} v.{}:\n", variables_of_type, name, name);
        declarations += fmt::format("{0} FUNCTION f.{0} (VAL {0} x) IS x:\n", name);
        for (std::size_t i = 0; i < variables_of_type; ++i) {
            declarations += fmt::format("{0} x{1}.{0}:\n", name, i);
            const std::string literal = ExpressionMaker::literal(maker.values()[index][i], type);
            values += fmt::format("  v.{0}[{1}] := {2}\n  x{1}.{0} := {2}\n", name, i, literal);
        }
    }
    return declarations + values + indented(body, 2);
}

/// Returns statements that store a value in `memory`, from this word on.
std::string storing(const RandomTerm& term, Basic type, std::size_t at) {
    if (type == Basic::integer)
        return fmt::format("memory[{}] := {}\n", at, term.text);
    if (type == Basic::boolean || type == Basic::byte || type == Basic::int16 || type == Basic::int32)
        return fmt::format("memory[{}] := INT {}\n", at, term.text);
    if (type == Basic::real32)
        return fmt::format("REAL32 r:\nSEQ\n  r := {}\n  VAL INT w RETYPES r:\n  memory[{}] := w\n", term.text, at);
    return fmt::format("{} r:\nSEQ\n  r := {}\n  VAL [2]INT w RETYPES r:\n  [memory FROM {} FOR 2] := w\n",
                       name_of(type), term.text, at);
}

/// Returns the two words of a value in memory.
std::array<std::int32_t, 2> words_of(const ExactValue& value, Basic type) {
    const auto bits = type == Basic::real64   ? std::bit_cast<std::int64_t>(value.real)
                      : type == Basic::real32 ? std::bit_cast<std::int32_t>(static_cast<float>(value.real))
                                              : static_cast<std::int64_t>(value.integer);
    return {static_cast<std::int32_t>(bits), static_cast<std::int32_t>(bits >> 32)};
}

} // namespace

TEST_CASE("random expressions of all types give what an exact evaluator gives") {
    for (const std::uint64_t seed : seeds(40)) {
        INFO(replay(seed));
        ExpressionMaker maker(seed);
        std::string body = "SEQ\n";
        std::vector<std::function<void(const Executed&)>> checks;
        std::size_t at = 0;
        for (int i = 0; i < 70; ++i) {
            const Basic type = tested_types[static_cast<std::size_t>(i) % tested_types.size()];
            const RandomTerm term = maker.make(type, 4);
            if (!term.value)
                continue;
            body += indented(storing(term, type, at), 2);
            checks.emplace_back([term, type, at](const Executed& done) {
                CAPTURE(term.text);
                CAPTURE(name_of(type));
                const auto expected = words_of(*term.value, type);
                CHECK(done.results[at] == expected[0]);
                if (occam::bytes_of(type) == 8)
                    CHECK(done.results[at + 1] == expected[1]);
            });
            at += 2;
        }
        const auto mode = static_cast<occam::ErrorMode>(seed % 3);
        const auto model = seed % 2 == 0 ? transputer::Model::t800 : transputer::Model::t414;
        const Executed done = execute(with_variables(maker, body), {.model = model, .mode = mode});
        CHECK(done.trouble == "");
        CHECK_FALSE(done.halted);
        for (const auto& check : checks)
            check(done);
    }
}

TEST_CASE("random expressions that are errors halt the processor, or stop the process") {
    int errors = 0;
    for (const std::uint64_t seed : seeds(400)) {
        INFO(replay(seed));
        ExpressionMaker maker(seed + 1000);
        const Basic type = tested_types[seed % tested_types.size()];
        const RandomTerm term = maker.make(type, 5);
        if (term.value)
            continue;
        ++errors;
        CAPTURE(term.text);
        const std::string body =
            with_variables(maker, "memory[0] := 1\n" + storing(term, type, 2) + "memory[1] := 1\n");
        const auto model = seed % 3 == 0 ? transputer::Model::t414 : transputer::Model::t800;
        const Executed halted = execute(body, {.model = model});
        CHECK(halted.halted);
        CHECK(halted.results[0] == 1);
        const Executed stopped = execute(body, {.model = model, .mode = occam::ErrorMode::stop});
        CHECK_FALSE(stopped.halted);
        CHECK(stopped.results[0] == 1);
        CHECK(stopped.results[1] == 0);
    }
    CHECK((errors > 10 || !all_seeds()));
}
