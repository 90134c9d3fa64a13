#include "netlist/language/lexer.hpp"

#include "netlist/language/characters.hpp"

#include <fmt/format.h>

#include <charconv>

namespace placedpar {

Token Lexer::read_number() {
    Token token{TokenKind::integer, "", {}, 0, here()};
    auto start = position_;
    bool real = false;
    if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X')) {
        advance();
        advance();
        while (is_hex_digit(peek()))
            advance();
        token = read_integer(std::string_view(text()).substr(start + 2, position_ - start - 2), 16, token);
    } else {
        while (is_digit(peek()))
            advance();
        if (peek() == '.') {
            real = true;
            advance();
            while (is_digit(peek()))
                advance();
        }
        auto sign = peek(1) == '+' || peek(1) == '-' ? 1U : 0U;
        if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
            real = true;
            advance();
            advance();
            while (is_digit(peek()))
                advance();
        }
        auto digits = std::string_view(text()).substr(start, position_ - start);
        auto float_suffix = peek() == 'f' || peek() == 'F' || peek() == 'l' || peek() == 'L';
        token = real || float_suffix ? read_real(digits, token) : read_integer(digits, 10, token);
    }
    auto suffix = position_;
    while (in_name(peek()))
        advance();
    if (suffix != position_)
        reporter_.error(
            token.at,
            fmt::format("\"{}\" is no number", text().substr(start, std::min<std::size_t>(60, position_ - start))),
            "a name begins with a letter; the suffixes of a number are k, K, m, M, f and l");
    token.text = text().substr(start, position_ - start);
    return token;
}

Token Lexer::read_real(std::string_view digits, Token token) {
    token.kind = TokenKind::real;
    auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), token.real);
    if (problem == std::errc::result_out_of_range)
        reporter_.error(token.at, "the number is beyond the range of a double");
    if (peek() == 'f' || peek() == 'F' || peek() == 'l' || peek() == 'L')
        advance();
    return token;
}

Token Lexer::read_integer(std::string_view digits, int base, Token token) {
    auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), token.integer.value, base);
    if (problem == std::errc::result_out_of_range)
        reporter_.error(token.at, "the number is beyond 64 bits");
    else if (digits.empty())
        reporter_.error(token.at, "0x needs hexadecimal digits behind it");
    token.integer.decimal = token.integer.value;
    apply_suffix(token);
    return token;
}

void Lexer::apply_suffix(Token& token) {
    std::int64_t binary = 1, decimal = 1;
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
    token.integer.decimal *= decimal; // smaller than the other, which fits
}

} // namespace placedpar
