// Random expressions of all types.

#include "random_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

namespace placedpar::test {

using occam::Basic;
using occam::name_of;

int bits_of_type(Basic type) { return static_cast<int>(8 * occam::bytes_of(type)); }
bool is_real_type(Basic type) { return type == Basic::real32 || type == Basic::real64; }

WideInteger wrapped_to(WideInteger value, Basic type) {
    const WideInteger range = WideInteger{1} << bits_of_type(type);
    value = ((value % range) + range) % range;
    return value >= range / 2 && type != Basic::byte ? value - range : value;
}

ProgramValue fitted(WideInteger value, Basic type) {
    if (wrapped_to(value, type) != value)
        throw ProgramError{};
    return {value, 0};
}

ProgramValue fitted_real(double value, Basic type) {
    if (type == Basic::real32)
        value = static_cast<float>(value);
    if (!std::isfinite(value))
        throw ProgramError{};
    return {0, value};
}

std::vector<std::int32_t> words_of_value(const ProgramValue& value, Basic type) {
    if (type == Basic::real32)
        return {std::bit_cast<std::int32_t>(static_cast<float>(value.real))};
    const std::int64_t bits =
        type == Basic::real64 ? std::bit_cast<std::int64_t>(value.real) : static_cast<std::int64_t>(value.integer);
    if (occam::bytes_of(type) == 8)
        return {static_cast<std::int32_t>(bits), static_cast<std::int32_t>(bits >> 32)};
    return {static_cast<std::int32_t>(bits)};
}

namespace {

std::set<std::size_t> both(std::set<std::size_t> a, const std::set<std::size_t>& b) {
    a.insert(b.begin(), b.end());
    return a;
}

ProgramTerm joined(const ProgramTerm& left, const char* symbol, const ProgramTerm& right,
                   std::function<ProgramValue(const ProgramValue&, const ProgramValue&)> operation) {
    return {fmt::format("({} {} {})", left.text, symbol, right.text),
            [left = left.value, right = right.value, operation = std::move(operation)](ProgramMemory& memory) {
                const ProgramValue a = left(memory);
                return operation(a, right(memory));
            },
            left.is_constant && right.is_constant, both(left.reads, right.reads)};
}

ProgramTerm literal_term(WideInteger value, Basic type) {
    const auto number = static_cast<std::int64_t>(value);
    std::string text =
        number < 0 ? fmt::format("(-{}({}))", std::uint64_t{0} - static_cast<std::uint64_t>(number), name_of(type))
                   : fmt::format("{}({})", number, name_of(type));
    if (type == Basic::boolean)
        text = value != 0 ? "TRUE" : "FALSE";
    if (type == Basic::integer)
        text = number < 0 ? fmt::format("(-{})", -number) : std::to_string(number);
    return {text, [value](ProgramMemory&) { return ProgramValue{value, 0}; }, true, {}};
}

template <class T>
bool compares(std::size_t which, T a, T b) {
    const std::array<bool, 6> results{a == b, a != b, a<b, a> b, a <= b, a >= b};
    return results[which];
}

} // namespace

ProgramTerm RandomProgram::literal(Basic type) {
    if (is_real_type(type)) {
        const double value = (static_cast<double>(random_.below(2001)) - 1000) / 64;
        const std::string digits = fmt::format("{:.17E}({})", std::abs(value), name_of(type));
        return {value < 0 ? "(-" + digits + ")" : digits,
                [value](ProgramMemory&) {
                    return ProgramValue{0, value};
                },
                true,
                {}};
    }
    if (type == Basic::boolean)
        return literal_term(random_.below(2), type);
    const auto shift = random_.below(static_cast<std::uint32_t>(bits_of_type(type)));
    const auto raw = static_cast<std::int64_t>(std::uint64_t{random_.below(~0U)} << 32 | random_.below(~0U));
    if (type == Basic::byte)
        return literal_term((raw & 255) >> shift, type);
    return literal_term(wrapped_to(raw >> (63 - shift), type), type);
}

ProgramTerm RandomProgram::leaf(Basic type) {
    if (!has_spot(type, false) || random_.chance(0.2))
        return literal(type);
    const ProgramSpot found = spot(type, false);
    return {found.text, [cells = found.cells](ProgramMemory& memory) { return cells(memory)[0]; }, false,
            both(found.reads, {found.name})};
}

/// Returns a term that is not constant: a compiler refuses errors in constant expressions.
ProgramTerm RandomProgram::variable_term(Basic type, int depth) {
    ProgramTerm result = term(type, depth);
    if (!result.is_constant)
        return result;
    const ProgramSpot found = spot(type, false);
    return {found.text, [cells = found.cells](ProgramMemory& memory) { return cells(memory)[0]; }, false,
            both(found.reads, {found.name})};
}

ProgramTerm RandomProgram::term(Basic type, int depth) {
    if (depth <= 0 || random_.chance(0.15))
        return leaf(type);
    if (type == Basic::boolean)
        return condition(depth);
    if (random_.chance(0.1))
        for (const FunctionName& each : functions_)
            if (each.type == type && random_.chance(0.7))
                return call(each, depth);
    if (random_.chance(0.15))
        return conversion(type, depth);
    if (is_real_type(type))
        return real_operation(type, depth);
    if (random_.chance(0.4))
        return checked_operation(type, depth);
    return type != Basic::byte && random_.chance(0.2) ? shift(type, depth) : integer_operation(type, depth);
}

/// Returns the lowest bits of a term: a small number that is not negative.
ProgramTerm RandomProgram::masked(Basic type, const ProgramTerm& operand, int bits) {
    const WideInteger mask = (WideInteger{1} << bits) - 1;
    return joined(operand, "/\\", literal_term(mask, type), [](const ProgramValue& a, const ProgramValue& b) {
        return ProgramValue{a.integer & b.integer, 0};
    });
}

ProgramTerm RandomProgram::integer_operation(Basic type, int depth) {
    const ProgramTerm left = variable_term(type, depth - 1), right = term(type, depth - 1);
    const bool is_byte = type == Basic::byte;
    const auto which = random_.below(is_byte ? 3 : 6);
    constexpr std::array<const char*, 6> symbols{"/\\", "\\/", "><", "PLUS", "MINUS", "TIMES"};
    if (!is_byte && random_.chance(0.1))
        return {fmt::format("(~{})", left.text),
                [value = left.value](ProgramMemory& memory) {
                    return ProgramValue{~value(memory).integer, 0};
                },
                false, left.reads};
    return joined(left, symbols[which], right, [which, type](const ProgramValue& a, const ProgramValue& b) {
        const WideInteger x = a.integer, y = b.integer;
        switch (which) {
        case 0: return ProgramValue{x & y, 0};
        case 1: return ProgramValue{x | y, 0};
        case 2: return ProgramValue{x ^ y, 0};
        case 3: return ProgramValue{wrapped_to(x + y, type), 0};
        case 4: return ProgramValue{wrapped_to(x - y, type), 0};
        default: // the product of 64 bits has at most 127, and its sign
            return ProgramValue{wrapped_to(x * y, type), 0};
        }
    });
}

/// Returns an operation that may overflow. Its operands are mostly small enough.
ProgramTerm RandomProgram::checked_operation(Basic type, int depth) {
    const auto which = random_.below(5);
    const int bits = bits_of_type(type);
    const bool is_small = random_.chance(0.999);
    ProgramTerm left = variable_term(type, depth - 1), right = variable_term(type, depth - 1);
    if (is_small && which < 3)
        left = masked(type, left, which == 2 ? bits / 2 - 1 : bits - 2);
    if (is_small)
        right = masked(type, right, which == 2 ? bits / 2 - 1 : which > 2 ? 3 : bits - 2);
    if (is_small && (which == 3 || which == 4))
        right = joined(right, "\\/", literal_term(1, type), [](const ProgramValue& a, const ProgramValue&) {
            return ProgramValue{a.integer | 1, 0};
        });
    if (is_small && which == 1 && type == Basic::byte)
        left = joined(left, "\\/", literal_term(128, type), [](const ProgramValue& a, const ProgramValue&) {
            return ProgramValue{a.integer | 128, 0};
        });
    constexpr std::array<const char*, 5> symbols{"+", "-", "*", "/", "\\"};
    return joined(left, symbols[which], right, [which, type](const ProgramValue& a, const ProgramValue& b) {
        const WideInteger x = a.integer, y = b.integer;
        if (which > 2 && y == 0)
            throw ProgramError{};
        if (which == 4 && wrapped_to(x / y, type) != x / y)
            throw ProgramError{};
        return fitted(which == 0 ? x + y : which == 1 ? x - y : which == 2 ? x * y : which == 3 ? x / y : x % y, type);
    });
}

ProgramTerm RandomProgram::shift(Basic type, int depth) {
    const ProgramTerm left = variable_term(type, depth - 1);
    const int bits = bits_of_type(type);
    ProgramTerm places = literal_term(random_.below(static_cast<std::uint32_t>(bits) + 1), Basic::integer);
    if (random_.chance(0.5))
        places = masked(Basic::integer, variable_term(Basic::integer, depth - 1), bits == 64 ? 6 : bits == 32 ? 5 : 4);
    const bool is_left = random_.chance(0.5);
    return joined(left, is_left ? "<<" : ">>", places,
                  [is_left, bits, type](const ProgramValue& a, const ProgramValue& b) {
                      const WideInteger raw = a.integer & ((WideInteger{1} << bits) - 1);
                      const int n = static_cast<int>(b.integer);
                      return ProgramValue{wrapped_to(is_left ? (n >= bits ? 0 : raw << n) : raw >> n, type), 0};
                  });
}

ProgramTerm RandomProgram::real_operation(Basic type, int depth) {
    const auto which = random_.chance(0.9) ? random_.below(2) : 2 + random_.below(2);
    const ProgramTerm left = variable_term(type, depth - 1);
    const ProgramTerm right = which > 1 && random_.chance(0.8) ? literal(type) : term(type, depth - 1);
    constexpr std::array<const char*, 4> symbols{"+", "-", "*", "/"};
    ProgramTerm result =
        joined(left, symbols[which], right, [which, type](const ProgramValue& a, const ProgramValue& b) {
            if (which == 3 && b.real == 0)
                throw ProgramError{};
            const auto computed = [&](auto x, auto y) -> double {
                return which == 0 ? x + y : which == 1 ? x - y : which == 2 ? x * y : x / y;
            };
            return type == Basic::real32
                       ? fitted_real(computed(static_cast<float>(a.real), static_cast<float>(b.real)), type)
                       : fitted_real(computed(a.real, b.real), type);
        });
    return result;
}

ProgramTerm RandomProgram::conversion(Basic to, int depth) {
    static constexpr std::array integers{Basic::byte, Basic::integer, Basic::int16, Basic::int32, Basic::int64};
    static constexpr std::array for_reals{Basic::integer, Basic::int16, Basic::int32, Basic::int64};
    if (is_real_type(to)) {
        if (random_.chance(0.4)) {
            const Basic other = to == Basic::real32 ? Basic::real64 : Basic::real32;
            const ProgramTerm from = variable_term(other, depth - 1);
            return {fmt::format("({} {}{})", name_of(to), to == Basic::real32 ? "ROUND " : "", from.text),
                    [to, value = from.value](ProgramMemory& memory) { return fitted_real(value(memory).real, to); },
                    false, from.reads};
        }
        const Basic type = one_of(for_reals);
        const ProgramTerm from = variable_term(type, depth - 1);
        return {fmt::format("({} ROUND {})", name_of(to), from.text),
                [to, value = from.value](ProgramMemory& memory) {
                    const auto integer = static_cast<std::int64_t>(value(memory).integer);
                    return ProgramValue{0, to == Basic::real32 ? static_cast<double>(static_cast<float>(integer))
                                                               : static_cast<double>(integer)};
                },
                false, from.reads};
    }
    if (to != Basic::byte && has_reals_ && random_.chance(0.05)) {
        const Basic type = random_.chance(0.5) ? Basic::real32 : Basic::real64;
        const bool rounds = random_.chance(0.5);
        const ProgramTerm from = variable_term(type, depth - 1);
        return {fmt::format("({} {} {})", name_of(to), rounds ? "ROUND" : "TRUNC", from.text),
                [to, rounds, value = from.value](ProgramMemory& memory) {
                    const double real = value(memory).real;
                    if (std::abs(real) > 1e19)
                        throw ProgramError{};
                    return fitted(static_cast<WideInteger>(rounds ? std::nearbyint(real) : std::trunc(real)), to);
                },
                false, from.reads};
    }
    const Basic type = random_.chance(0.1) ? Basic::boolean : one_of(integers);
    ProgramTerm from = variable_term(type, depth - 1);
    if (bits_of_type(type) >= bits_of_type(to) && type != Basic::boolean && random_.chance(0.998))
        from = masked(type, from, bits_of_type(to) - 1);
    return {fmt::format("({} {})", name_of(to), from.text),
            [to, value = from.value](ProgramMemory& memory) { return fitted(value(memory).integer, to); }, false,
            from.reads};
}

ProgramTerm RandomProgram::condition(int depth) {
    const auto which = random_.below(4);
    if (which > 1)
        return comparison(depth);
    if (which == 0) {
        const ProgramTerm operand = term(Basic::boolean, depth - 1);
        return {fmt::format("(NOT {})", operand.text),
                [value = operand.value](ProgramMemory& memory) {
                    return ProgramValue{1 - value(memory).integer, 0};
                },
                operand.is_constant, operand.reads};
    }
    const ProgramTerm left = variable_term(Basic::boolean, depth - 1), right = term(Basic::boolean, depth - 1);
    const bool is_and = random_.chance(0.5);
    return {fmt::format("({} {} {})", left.text, is_and ? "AND" : "OR", right.text),
            [is_and, a = left.value, b = right.value](ProgramMemory& memory) {
                const ProgramValue first = a(memory);
                return (first.integer != 0) == is_and ? b(memory) : first;
            },
            false, both(left.reads, right.reads)};
}

ProgramTerm RandomProgram::comparison(int depth) {
    constexpr std::array<const char*, 6> symbols{"=", "<>", "<", ">", "<=", ">="};
    Basic type = any_type();
    if (type == Basic::boolean)
        type = Basic::integer;
    const auto which = random_.below(static_cast<std::uint32_t>(symbols.size()));
    const ProgramTerm left = variable_term(type, depth - 1), right = term(type, depth - 1);
    if (type == Basic::integer && random_.chance(0.2))
        return joined(left, "AFTER", right, [](const ProgramValue& a, const ProgramValue& b) {
            return ProgramValue{wrapped_to(a.integer - b.integer, Basic::integer) > 0 ? 1 : 0, 0};
        });
    return joined(left, symbols[which], right, [which, type](const ProgramValue& a, const ProgramValue& b) {
        const bool holds = is_real_type(type) ? compares(which, a.real, b.real) : compares(which, a.integer, b.integer);
        return ProgramValue{holds ? 1 : 0, 0};
    });
}

ProgramTerm RandomProgram::call(const FunctionName& function, int depth) {
    const ProgramTerm first = term(function.type, depth - 1), second = term(Basic::integer, depth - 1);
    return {fmt::format("{} ({}, {})", function.text, first.text, second.text),
            [this_function = function.body, a = first.value, b = second.value, one = function.first.number,
             two = function.second.number](ProgramMemory& memory) {
                std::vector<ProgramValue> values{a(memory)}, others{b(memory)};
                const auto before = std::pair(memory.named[one], memory.named[two]);
                memory.named[one] = values, memory.named[two] = others;
                const ProgramValue result = this_function(memory);
                std::tie(memory.named[one], memory.named[two]) = before;
                return result;
            },
            false, both(first.reads, second.reads)};
}

/// Returns a scalar variable.
ProgramTerm RandomProgram::scalar_term(Basic type) {
    std::vector<Name> fitting;
    for (const Name& each : names_)
        if (each.type == type && each.sizes.empty())
            fitting.push_back(each);
    const Name& name = one_of(fitting);
    return {name.text,
            [number = name.number](ProgramMemory& memory) { return memory.named[number][0]; },
            false,
            {name.number}};
}

/// Returns a subscript, which is in range but rarely.
ProgramTerm RandomProgram::subscript(std::uint32_t size) {
    if (random_.chance(0.4))
        return literal_term(random_.below(size), Basic::integer);
    ++subscripts_;
    const bool is_simple = subscripts_ > 2 || random_.chance(0.5);
    const ProgramTerm any = is_simple ? scalar_term(Basic::integer) : variable_term(Basic::integer, 1);
    --subscripts_;
    if (random_.chance(0.001))
        return any;
    const ProgramTerm index = masked(Basic::integer, any, 10);
    return joined(index, "\\", literal_term(size, Basic::integer), [](const ProgramValue& a, const ProgramValue& b) {
        return ProgramValue{a.integer % b.integer, 0};
    });
}

ProgramSpot RandomProgram::element(const Name& name) {
    ProgramSpot found{name.text, {}, name.number, {}};
    std::vector<std::function<ProgramValue(ProgramMemory&)>> subscripts;
    for (const std::uint32_t size : name.sizes) {
        const ProgramTerm index = subscript(size);
        found.text += "[" + index.text + "]";
        found.reads = both(found.reads, index.reads);
        subscripts.push_back(index.value);
    }
    found.cells = [subscripts, sizes = name.sizes, number = name.number](ProgramMemory& memory) {
        std::size_t at = 0;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const WideInteger index = subscripts[i](memory).integer;
            if (index < 0 || index >= sizes[i])
                throw ProgramError{};
            at = at * sizes[i] + static_cast<std::size_t>(index);
        }
        return memory.named[number].subspan(at, 1);
    };
    return found;
}

bool RandomProgram::has_spot(Basic type, bool is_written) const {
    return std::ranges::any_of(
        names_, [&](const Name& each) { return each.type == type && (each.is_writable || !is_written); });
}

/// REQUIRES: has_spot(type, is_written).
ProgramSpot RandomProgram::spot(Basic type, bool is_written) {
    std::vector<Name> fitting;
    for (const Name& each : names_)
        if (each.type == type && (each.is_writable || !is_written))
            fitting.push_back(each);
    return element(one_of(fitting));
}

Basic RandomProgram::any_type() {
    static constexpr std::array types{Basic::boolean, Basic::byte,  Basic::integer, Basic::integer, Basic::int16,
                                      Basic::int32,   Basic::int64, Basic::real32,  Basic::real64};
    const Basic type = one_of(types);
    return is_real_type(type) && !has_reals_ ? Basic::int64 : type;
}

} // namespace placedpar::test
