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
    illegal,   ///< text that is not a token; the lexer has reported it
    directive, ///< `#include`; `text` holds the word after `#`
    end
};

/// Holds both readings of an integer constant with a suffix: `20M` is 20971520 as a size (`value`) and 20000000 as a
/// frequency (`decimal`). Attributes such as `clock` and `linkspeed` take the second reading
/// (AttributeDescription::decimal_suffixes). Arithmetic computes both readings, so that the suffix keeps its meaning in
/// a `val`.
struct Integer {
    std::int64_t value = 0;
    std::int64_t decimal = 0;
};

struct Token {
    TokenKind kind = TokenKind::end;
    std::string text; ///< the name, the symbol, or the characters of the string
    Integer integer;
    double real = 0;
    Location at;
    Location end = {}; ///< the place after its last character

    bool is(std::string_view symbol) const { return kind == TokenKind::symbol && text == symbol; }
    bool is_word(std::string_view word) const { return kind == TokenKind::name && text == word; }
};

/// Returns a text that names the token in a message: `"link"`, `the string "x"`, `the end of the file`.
std::string describe(const Token& token);

} // namespace placedpar
