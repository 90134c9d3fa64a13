#include "netlist/language/lexer.hpp"

#include "netlist/language/characters.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

namespace placedpar {

namespace {

std::string shown(std::string_view character, char32_t code) {
    return code < 0x80 ? fmt::format("\"{}\"", character)
                       : fmt::format("\"{}\" (U+{:04X})", character, static_cast<std::uint32_t>(code));
}

/// Returns a hint for a character that word processors write in place of a character of the language, such as a dash
/// for "-"; "" for other characters.
std::string character_meant(char32_t code) {
    static constexpr std::u32string_view dashes = U"\u2010\u2011\u2012\u2013\u2014\u2212",
                                         quotes = U"\u201c\u201d\u201e", apostrophes = U"\u2018\u2019\u201a",
                                         blanks = U"\u00a0\u2003\u2009\u200b\ufeff";
    auto is_in = [code](std::u32string_view set) { return set.find(code) != set.npos; };
    return is_in(dashes)        ? "write -"
           : is_in(quotes)      ? "write \""
           : is_in(apostrophes) ? "write '"
           : is_in(blanks)      ? "write a blank"
           : code == '#'        ? "#include must begin its line"
                                : "";
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

Lexer::Lexer(std::shared_ptr<const SourceFile> file, Reporter& reporter, std::vector<PartOrigin> origins)
    : file_(std::move(file)), reporter_(reporter), origins_(std::move(origins)) {}

Location Lexer::origin() const {
    const auto next = std::ranges::upper_bound(origins_, position_, {}, &PartOrigin::offset);
    return std::prev(next)->place;
}

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
    reporter_.error(start, "the comment does not end", "close it with */");
}

void Lexer::skip_line() {
    while (!at_end() && peek() != '\n')
        advance();
}

void Lexer::skip_line_comment(std::string_view mark) {
    reporter_.error(here(), fmt::format("comments do not begin with {} in this language", mark), "write /* ... */");
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
            skip_line_comment("//");
        else if (begins_line && peek() == '-' && peek(1) == '-')
            skip_line_comment("--");
        else
            return read_symbol();
    }
}

void Lexer::check_length(const Token& name) {
    if (name.text.size() > longest_name)
        reporter_.error(name.at, fmt::format("the name is too long: at most {} characters are allowed", longest_name));
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
    if (one_character.find(peek()) == std::string_view::npos)
        return refuse_character(std::move(token));
    token.text = std::string(1, peek());
    advance();
    return token;
}

/// Reports a character that cannot begin a token. A character of several bytes is one error.
Token Lexer::refuse_character(Token token) {
    auto [code, bytes] = first_character(std::string_view(text()).substr(position_));
    token.kind = TokenKind::illegal;
    token.text = text().substr(position_, std::max<std::size_t>(bytes, 1));
    reporter_.error(token.at,
                    "illegal character " + (bytes == 0
                                                ? fmt::format("byte 0x{:02x}", static_cast<unsigned char>(peek()))
                                                : shown(token.text, code)),
                    character_meant(code));
    for (std::size_t i = 0; i < token.text.size(); ++i)
        advance();
    return token;
}

} // namespace placedpar
