#pragma once

#include "text/source.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

enum class TokenKind {
    name,
    integer,
    real,
    text,      ///< a string constant
    symbol,    ///< punctuation and operators, in `text`
    illegal,   ///< text that the lexer could not read, and has reported
    directive, ///< `#include`; `text` holds the word after `#`
    end
};

/// Holds an integer constant in both readings of its suffix: `20M` is 20971520 as a size and 20000000 as a frequency.
/// Some attributes, such as `clock` and `linkspeed`, take the second reading (AttributeDescription::decimal_suffixes).
/// Constants keep both readings through `val`s and arithmetic.
struct Integer {
    std::int64_t value = 0;
    std::int64_t decimal = 0;
};

struct Token {
    TokenKind kind = TokenKind::end;
    std::string text; ///< name, symbol, or the string with its escapes resolved
    Integer integer;
    double real = 0;
    Location at;
    Location end = {}; ///< the location after its last character

    bool is(std::string_view symbol) const { return kind == TokenKind::symbol && text == symbol; }
    bool is_word(std::string_view word) const { return kind == TokenKind::name && text == word; }
};

/// Returns the token's name in a message: `"link"`, `the string "x"`, `the end of the file`.
std::string describe(const Token& token);

} // namespace placedpar
