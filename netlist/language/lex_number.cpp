#include "netlist/language/lexer.hpp"

#include "netlist/language/characters.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace placedpar {

Token Lexer::read_number() {
    Token token{TokenKind::integer, "", {}, 0, here()};
    auto start = position_;
    if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X'))
        token = read_hexadecimal(token);
    else
        token = read_decimal(token);
    refuse_letters_behind(token, start);
    token.text = text().substr(start, position_ - start);
    return token;
}

Token Lexer::read_hexadecimal(Token token) {
    advance();
    advance();
    return read_integer(take_while(is_hex_digit), 16, token);
}

Token Lexer::read_decimal(Token token) {
    auto start = position_;
    take_while(is_digit);
    bool real = skip_fraction();
    real = skip_exponent() || real;
    auto digits = std::string_view(text()).substr(start, position_ - start);
    if (real || at_float_suffix())
        return read_real(digits, token);
    return digits.size() > 1 && digits[0] == '0' ? read_octal(digits, token) : read_integer(digits, 10, token);
}

/// Reads a number with a leading 0, which is octal as in C.
Token Lexer::read_octal(std::string_view digits, Token token) {
    auto illegal = digits.find_first_of("89");
    if (illegal == std::string_view::npos)
        return read_integer(digits, 8, token);
    auto significant = digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
    auto at = token.at;
    at.column += illegal;
    reporter_.error(at, fmt::format("{} is not an octal digit", digits[illegal]),
                    fmt::format("a leading 0 makes a number octal (base 8); write {} for the decimal number",
                                significant.substr(0, 60)));
    apply_suffix(token);
    return token;
}

bool Lexer::skip_fraction() {
    if (peek() != '.')
        return false;
    advance();
    take_while(is_digit);
    return true;
}

bool Lexer::skip_exponent() {
    auto sign = peek(1) == '+' || peek(1) == '-' ? 1U : 0U;
    if ((peek() != 'e' && peek() != 'E') || !is_digit(peek(1 + sign)))
        return false;
    advance();
    advance();
    take_while(is_digit);
    return true;
}

bool Lexer::at_float_suffix() const { return peek() == 'f' || peek() == 'F' || peek() == 'l' || peek() == 'L'; }

/// Refuses letters directly behind a number: `5q` is neither a number nor the number 5 followed by the name q.
void Lexer::refuse_letters_behind(const Token& token, std::size_t start) {
    if (!in_name(peek()))
        return;
    take_while(in_name);
    reporter_.error(
        token.at,
        fmt::format("\"{}\" is not a number", text().substr(start, std::min<std::size_t>(60, position_ - start))),
        "a name must begin with a letter; a number can end with k, K, m, M, f or l, a time with ns, us, ms or s");
}

Token Lexer::read_real(std::string_view digits, Token token) {
    token.kind = TokenKind::real;
    auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), token.real);
    if (problem == std::errc::result_out_of_range)
        reporter_.error(token.at, "the number is beyond the range of a double");
    if (at_float_suffix())
        advance();
    std::int64_t unit = take_unit_of_time();
    return unit == 0 ? token : as_time(token, unit);
}

/// Takes a unit of time, and returns its length in nanoseconds. If there is no unit here, takes nothing and returns 0.
std::int64_t Lexer::take_unit_of_time() {
    static constexpr std::pair<std::string_view, std::int64_t> units[] = {
        {"ns", 1}, {"us", 1000}, {"ms", 1'000'000}, {"s", 1'000'000'000}};
    for (const auto& [name, nanoseconds] : units)
        if (text().compare(position_, name.size(), name) == 0 && !in_name(peek(name.size()))) {
            for (std::size_t i = 0; i < name.size(); ++i)
                advance();
            return nanoseconds;
        }
    return 0;
}

/// Returns the time as an integer, in nanoseconds: `1.5ms` is 1500000.
Token Lexer::as_time(Token token, std::int64_t nanoseconds) {
    double exact = token.real * static_cast<double>(nanoseconds);
    token.kind = TokenKind::integer;
    if (constexpr double most = 9e15; exact > most) {
        reporter_.error(token.at, "the time is longer than 104 days");
        return token;
    }
    token.integer.value = token.integer.decimal = std::llround(exact);
    if (std::abs(exact - static_cast<double>(token.integer.value)) > 1e-6)
        reporter_.error(token.at, "expected a whole number of nanoseconds");
    return token;
}

Token Lexer::read_integer(std::string_view digits, int base, Token token) {
    auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), token.integer.value, base);
    if (problem == std::errc::result_out_of_range)
        reporter_.error(token.at, "the number is beyond 64 bits");
    else if (digits.empty())
        reporter_.error(token.at, "write hexadecimal digits after 0x");
    token.integer.decimal = token.integer.value;
    apply_suffix(token);
    return token;
}

void Lexer::apply_suffix(Token& token) {
    std::int64_t binary = 1, decimal = 1;
    if (std::int64_t nanoseconds = take_unit_of_time()) {
        if (__builtin_mul_overflow(token.integer.value, nanoseconds, &token.integer.value)) {
            reporter_.error(token.at, "the number is beyond 64 bits");
            token.integer = {};
        }
        token.integer.decimal = token.integer.value;
        return;
    }
    if (peek() == 'k' || peek() == 'K') {
        binary = 1024;
        decimal = 1000;
    } else if (peek() == 'm' || peek() == 'M') {
        binary = 1024 * 1024;
        decimal = 1000 * 1000;
    } else {
        return;
    }
    advance();
    if (__builtin_mul_overflow(token.integer.value, binary, &token.integer.value)) {
        reporter_.error(token.at, "the number is beyond 64 bits");
        token.integer = {};
    }
    token.integer.decimal *= decimal; // no overflow: the product is at most token.integer.value
}

} // namespace placedpar
