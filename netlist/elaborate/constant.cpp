#include "netlist/elaborate/constant.hpp"

#include "text/counted.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace placedpar {

double as_real(const Constant& constant) {
    const auto* integer = constant.integer();
    return integer != nullptr ? static_cast<double>(integer->value) : *constant.real();
}

namespace {

/// Shifts to the left. Returns false if the result does not fit into 64 bits, or if `b` is not 0 to 62.
bool shift_left(std::int64_t a, std::int64_t b, std::int64_t& result) {
    return b >= 0 && b < 63 && !__builtin_mul_overflow(a, std::int64_t{1} << b, &result);
}

/// Shifts to the right and keeps the sign. Returns false if `b` is not 0 to 63.
bool shift_right(std::int64_t a, std::int64_t b, std::int64_t& result) {
    if (b < 0 || b > 63)
        return false;
    result = a >> b;
    return true;
}

/// Computes an integer operation. Returns false if there is no result, or if the result does not fit into 64 bits.
bool integer_operation(char symbol, std::int64_t a, std::int64_t b, std::int64_t& result) {
    switch (symbol) {
    case '+': return !__builtin_add_overflow(a, b, &result);
    case '-': return !__builtin_sub_overflow(a, b, &result);
    case '*': return !__builtin_mul_overflow(a, b, &result);
    case '&': result = a & b; return true;
    case '|': result = a | b; return true;
    case '^': result = a ^ b; return true;
    case '<': return shift_left(a, b, result);
    case '>': return shift_right(a, b, result);
    default: break;
    }
    if (b == 0 || (a == std::numeric_limits<std::int64_t>::min() && b == -1))
        return false;
    result = symbol == '/' ? a / b : a % b;
    return true;
}

Constant integer_arithmetic(const std::string& symbol, const Integer& a, const Integer& b) {
    Integer result;
    if ((symbol == "/" || symbol == "%") && b.value == 0)
        throw NoResult{"division by zero", ""};
    if ((symbol == "<<" || symbol == ">>") && (b.value < 0 || b.value > 63))
        throw NoResult{fmt::format("an integer cannot be shifted by {} bits", b.value), "expected 0 to 63"};
    if (!integer_operation(symbol[0], a.value, b.value, result.value))
        throw NoResult{fmt::format("{} {} {} is beyond 64 bits", a.value, symbol, b.value), ""};
    if (!integer_operation(symbol[0], a.decimal, b.decimal, result.decimal))
        result.decimal = result.value;
    return {result};
}

bool takes_only_integers(std::string_view symbol) {
    return symbol == "<<" || symbol == ">>" || std::string_view("%&|^~!").find(symbol) != std::string_view::npos;
}

Constant real_arithmetic(const std::string& symbol, double a, double b) {
    if (takes_only_integers(symbol))
        throw NoResult{fmt::format("wrong type for the operator {}: expected integers", symbol), ""};
    if (symbol == "/" && b == 0)
        throw NoResult{"division by zero", ""};
    auto result = symbol == "+" ? a + b : symbol == "-" ? a - b : symbol == "*" ? a * b : a / b;
    if (!std::isfinite(result))
        throw NoResult{fmt::format("{} {} {} is beyond the range of a double", a, symbol, b), ""};
    return {result};
}

template <typename T>
bool compare(const std::string& symbol, const T& a, const T& b) {
    if (symbol == "==")
        return a == b;
    if (symbol == "!=")
        return a != b;
    if (symbol == "<")
        return a < b;
    if (symbol == ">")
        return a > b;
    return symbol == "<=" ? a <= b : a >= b;
}

bool is_comparison(const std::string& symbol) {
    return symbol == "==" || symbol == "!=" || symbol == "<" || symbol == ">" || symbol == "<=" || symbol == ">=";
}

[[noreturn]] void wrong_type(const std::string& symbol, const std::string& operands) {
    throw NoResult{fmt::format("wrong type for the operator {}: {}", symbol, operands), ""};
}

} // namespace

Constant integer_constant(std::int64_t value) { return {Integer{value, value}}; }

std::string type_name(const Constant& constant) {
    static constexpr std::array names{"an integer", "a real number", "a string", "an array"};
    return names[constant.value.index()];
}

namespace {

std::string shown_array(const std::vector<Constant>& elements) {
    constexpr std::size_t long_enough = 32;
    std::string text;
    for (const Constant& element : elements) {
        if (text.size() > long_enough)
            return "{" + text + ", ...}";
        text += (text.empty() ? "" : ", ") + shown(element);
    }
    return "{" + text + "}";
}

} // namespace

std::string shown(const Constant& constant) {
    if (const auto* integer = constant.integer())
        return fmt::format("{}", integer->value);
    if (const auto* real = constant.real())
        return fmt::format("{}", *real);
    if (const auto* text = constant.text())
        return fmt::format("\"{}\"", text->size() > 40 ? text->substr(0, 40) + "..." : *text);
    return shown_array(**constant.array());
}

Constant apply_unary(const std::string& symbol, const Constant& operand) {
    if (const auto* integer = operand.integer()) {
        if (symbol == "!")
            return integer_constant(integer->value == 0 ? 1 : 0);
        if (symbol == "~")
            return {Integer{~integer->value, ~integer->decimal}};
        return symbol == "+" ? operand : integer_arithmetic("-", Integer{}, *integer);
    }
    if (const auto* real = operand.real(); real != nullptr && !takes_only_integers(symbol))
        return {symbol == "+" ? *real : -*real};
    wrong_type(symbol, "the operand is " + type_name(operand));
}

Constant apply_binary(const std::string& symbol, const Constant& left, const Constant& right) {
    if (left.text() != nullptr && right.text() != nullptr && is_comparison(symbol))
        return integer_constant(compare(symbol, *left.text(), *right.text()) ? 1 : 0);
    if (!left.is_number() || !right.is_number())
        wrong_type(symbol, fmt::format("the operands are {} and {}", type_name(left), type_name(right)));
    bool integers = left.integer() != nullptr && right.integer() != nullptr;
    if (is_comparison(symbol)) {
        auto holds = integers ? compare(symbol, left.integer()->value, right.integer()->value)
                              : compare(symbol, as_real(left), as_real(right));
        return integer_constant(holds ? 1 : 0);
    }
    return integers ? integer_arithmetic(symbol, *left.integer(), *right.integer())
                    : real_arithmetic(symbol, as_real(left), as_real(right));
}

Constant apply_cast(const std::string& type, const Constant& operand) {
    if (!operand.is_number())
        throw NoResult{fmt::format("wrong type for the cast ({}): the operand is {}", type, type_name(operand)), ""};
    if (type == "double")
        return {as_real(operand)};
    if (type == "float")
        return {static_cast<double>(static_cast<float>(as_real(operand)))};
    Integer result;
    if (operand.integer() != nullptr) {
        result = *operand.integer();
    } else {
        auto whole = std::trunc(*operand.real());
        if (!(whole >= -0x1p63 && whole < 0x1p63))
            throw NoResult{fmt::format("{} is beyond 64 bits", *operand.real()), ""};
        result.value = result.decimal = static_cast<std::int64_t>(whole);
    }
    auto v = result.value;
    if (type == "char" && (v < -128 || v > 255))
        throw NoResult{fmt::format("{} is not a character", v), "expected a code from 0 to 255"};
    if (type == "short" && (v < -32768 || v > 32767))
        throw NoResult{fmt::format("{} does not fit into a short", v), "expected -32768 to 32767"};
    if (type == "int" && (v < -0x80000000LL || v > 0x7fffffffLL))
        throw NoResult{fmt::format("{} does not fit into an int", v), "expected -2147483648 to 2147483647"};
    return {result};
}

Constant apply_subscript(const Constant& array, const Constant& subscript) {
    if (array.is_number())
        throw NoResult{fmt::format("{} cannot be subscripted", type_name(array)), ""};
    if (subscript.integer() == nullptr)
        throw NoResult{fmt::format("wrong type for a subscript: {}", type_name(subscript)), "expected an integer"};
    auto size = array.text() != nullptr ? array.text()->size() : (*array.array())->size();
    auto index = subscript.integer()->value;
    if (index < 0 || static_cast<std::uint64_t>(index) >= size)
        throw NoResult{fmt::format("the subscript {} is outside of the array", index),
                       fmt::format("the array has {}, [0] to [{}]", counted(size, "element"),
                                   static_cast<std::int64_t>(size) - 1)};
    auto place = static_cast<std::size_t>(index);
    if (array.text() != nullptr)
        return integer_constant(static_cast<unsigned char>((*array.text())[place]));
    return (**array.array())[place];
}

Constant apply_size(const Constant& array) {
    if (array.text() != nullptr)
        return integer_constant(static_cast<std::int64_t>(array.text()->size()));
    if (array.array() == nullptr)
        throw NoResult{fmt::format("wrong type for size: {} is {}", shown(array), type_name(array)),
                       "expected an array or a string"};
    return integer_constant(static_cast<std::int64_t>((*array.array())->size()));
}

bool have_same_shape(const Constant& left, const Constant& right) {
    if (left.array() == nullptr || right.array() == nullptr)
        return left.value.index() == right.value.index() || (left.is_number() && right.is_number());
    const auto &rows = **left.array(), &others = **right.array();
    return rows.size() == others.size() && have_same_shape(rows.front(), others.front());
}

} // namespace placedpar
