#include "netlist/language/lexer.hpp"

#include "netlist/language/characters.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace placedpar {

namespace {

std::string shown(char c) {
    auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 ? fmt::format("\"{}\"", c) : fmt::format("byte 0x{:02x}", byte);
}

} // namespace

std::string describe(const Token& token) {
    switch (token.kind) {
    case TokenKind::end: return "the end of the file";
    case TokenKind::integer: return "the number " + token.text;
    case TokenKind::real: return "the number " + token.text;
    case TokenKind::text:
        return "the string \"" + (token.text.size() > 40 ? token.text.substr(0, 40) + "..." : token.text) + "\"";
    case TokenKind::directive: return "\"#" + token.text + "\"";
    case TokenKind::illegal:
    case TokenKind::name:
    case TokenKind::symbol: break;
    }
    return "\"" + (token.text.size() > 60 ? token.text.substr(0, 60) + "..." : token.text) + "\"";
}

Lexer::Lexer(std::shared_ptr<const SourceFile> file, Reporter& reporter)
    : file_(std::move(file)), reporter_(reporter) {}

char Lexer::peek(std::size_t ahead) const {
    return position_ + ahead < text().size() ? text()[position_ + ahead] : '\0';
}

void Lexer::advance() {
    if (peek() == '\n') {
        ++line_;
        column_ = 1;
        line_is_blank_so_far_ = true;
    } else {
        ++column_;
    }
    ++position_;
}

std::string_view Lexer::take_while(bool (*belongs)(char)) {
    auto start = position_;
    while (belongs(peek()))
        advance();
    return std::string_view(text()).substr(start, position_ - start);
}

void Lexer::skip_comment() {
    auto start = here();
    advance();
    advance();
    while (!at_end()) {
        if (peek() == '*' && peek(1) == '/') {
            advance();
            advance();
            return;
        }
        advance();
    }
    reporter_.error(start, "the comment has no end", "close it with */");
}

void Lexer::skip_line() {
    while (!at_end() && peek() != '\n')
        advance();
}

void Lexer::skip_line_comment() {
    reporter_.error(here(), "the language has no comments that begin with //", "write /* ... */");
    skip_line();
}

void Lexer::skip_blanks() {
    while (!at_end()) {
        if (std::isspace(static_cast<unsigned char>(peek())) != 0)
            advance();
        else if (peek() == '/' && peek(1) == '*')
            skip_comment();
        else
            return;
    }
}

Token Lexer::next() {
    while (true) {
        skip_blanks();
        if (at_end())
            return {.kind = TokenKind::end, .text = "", .integer = {}, .real = 0, .at = here()};
        auto begins_line = line_is_blank_so_far_;
        line_is_blank_so_far_ = false;
        if (starts_name(peek()))
            return read_name();
        if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1))))
            return read_number();
        if (peek() == '"')
            return read_string();
        if (peek() == '\'')
            return read_character();
        if (peek() == '#' && begins_line)
            return read_directive();
        if (peek() == '/' && peek(1) == '/')
            skip_line_comment();
        else
            return read_symbol();
    }
}

void Lexer::check_length(const Token& name) {
    if (name.text.size() > longest_name)
        reporter_.error(name.at, fmt::format("the name is too long: {} characters are allowed", longest_name));
}

Token Lexer::read_name() {
    Token token{TokenKind::name, "", {}, 0, here()};
    token.text = take_while(in_name);
    check_length(token);
    return token;
}

Token Lexer::read_directive() {
    Token token{TokenKind::directive, "", {}, 0, here()};
    advance();
    while (peek() == ' ' || peek() == '\t')
        advance();
    token.text = take_while(in_name);
    return token;
}

Token Lexer::read_symbol() {
    static constexpr std::array two_characters{"==", "!=", "<=", ">=", "&&", "||", "<<", ">>"};
    static constexpr std::string_view one_character = "(){}[],;.=+-*/%<>!~&|^?:";
    Token token{TokenKind::symbol, "", {}, 0, here()};
    for (std::string_view symbol : two_characters)
        if (peek() == symbol[0] && peek(1) == symbol[1]) {
            token.text = symbol;
            advance();
            advance();
            return token;
        }
    if (one_character.find(peek()) == std::string_view::npos) {
        reporter_.error(here(), "illegal character " + shown(peek()),
                        peek() == '#' ? "#include stands at the beginning of a line" : "");
        token.kind = TokenKind::illegal;
    }
    token.text = std::string(1, peek());
    advance();
    return token;
}

} // namespace placedpar
