#include "netlist/language/lexer.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

int digit_value(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return 99;
}

} // namespace

char Lexer::read_numeric_escape(int base, int most_digits, const Location& start) {
    int value = 0, digits = 0;
    for (; digits < most_digits && digit_value(peek()) < base; ++digits) {
        value = value * base + digit_value(peek());
        advance();
    }
    if (digits == 0)
        reporter_.error(start, "illegal escape: write hexadecimal digits after \\x");
    if (value > 255)
        reporter_.error(start, "illegal escape: the greatest character is \\377");
    return static_cast<char>(static_cast<unsigned char>(value));
}

/// Reads the rest of an escape, after its backslash.
char Lexer::read_escaped(const Location& start) {
    static constexpr std::string_view letters = "abfnrtv\\'\"?", meanings = "\a\b\f\n\r\t\v\\'\"?";
    auto c = peek();
    if (digit_value(c) < 8)
        return read_numeric_escape(8, 3, start);
    if (c == 'x') {
        advance();
        return read_numeric_escape(16, 2, start);
    }
    auto found = letters.find(c);
    if (found == std::string_view::npos || at_end()) {
        reporter_.error(start,
                        at_end() ? "illegal escape at the end of the file" : fmt::format("illegal escape \\{}", c),
                        "C's escapes are \\a \\b \\f \\n \\r \\t \\v \\\\ \\' \\\" \\? \\ooo and \\xhh");
        if (!at_end() && c != '\n')
            advance();
        return c;
    }
    advance();
    return meanings[found];
}

Token Lexer::read_string() {
    Token token{TokenKind::text, "", {}, 0, here()};
    advance();
    while (peek() != '"') {
        if (at_end() || peek() == '\n') {
            reporter_.error(token.at, "the string does not end on its line", "close it with \"");
            token.kind = TokenKind::illegal;
            return token;
        }
        token.text += read_one();
    }
    advance();
    if (token.text.size() > longest_string)
        reporter_.error(token.at,
                        fmt::format("the string is too long: at most {} characters are allowed", longest_string));
    return token;
}

std::optional<Token> Lexer::read_file_name() {
    while (peek() == ' ' || peek() == '\t')
        advance();
    auto line = std::string_view(text()).substr(position_, text().find_first_of("\r\n", position_) - position_);
    auto end = line.find('"', 1);
    if (!line.starts_with('"') || end == std::string_view::npos || end == 1)
        return std::nullopt;
    Token token{TokenKind::text, std::string(line.substr(1, end - 1)), {}, 0, here()};
    for (std::size_t i = 0; i <= end; ++i)
        advance();
    return token;
}

char Lexer::read_one() {
    auto start = here();
    char c = peek();
    advance();
    return c == '\\' ? read_escaped(start) : c;
}

Token Lexer::read_character() {
    Token token{TokenKind::integer, "", {}, 0, here()};
    auto start = position_;
    advance();
    if (at_end() || peek() == '\n' || peek() == '\'')
        return refuse_empty_character(token);
    token.integer.value = token.integer.decimal = static_cast<unsigned char>(read_one());
    if (peek() == '\'') {
        advance();
    } else {
        reporter_.error(token.at, "the character constant has no closing '",
                        "write a longer text as a string: \"...\"");
        token.kind = TokenKind::illegal;
        skip_line();
    }
    token.text = text().substr(start, position_ - start);
    return token;
}

Token Lexer::refuse_empty_character(Token token) {
    reporter_.error(token.at, "expected one character", "such as 'a' or '\\n'");
    if (peek() == '\'')
        advance();
    token.kind = TokenKind::illegal;
    return token;
}

} // namespace placedpar
