#pragma once

#include "netlist/language/token.hpp"
#include "text/reporter.hpp"

#include <optional>

namespace placedpar {

/// Short enough to be printed on one line with every character escaped.
inline constexpr std::size_t longest_string = 2000;
/// Short enough for a statement with several names, subscripts and all, to be printed on one line.
inline constexpr std::size_t longest_name = 255;

/// Cuts one source into tokens, one at a time. What it cannot read it reports, and returns as an illegal token.
/// Comments are C's: slash star to star slash; the language has no others.
class Lexer {
public:
    Lexer(std::shared_ptr<const SourceFile> file, Reporter& reporter);

    /// At the end a token of kind `end`, as often as it is called.
    Token next();
    /// Skips the rest of the line.
    void skip_line();
    /// Just behind `#include`: the name of a file in quotes, where a `\` is no escape but as it stands; nothing where
    /// none follows on this line.
    std::optional<Token> read_file_name();
    /// The place behind the last token.
    Location here() const { return {file_, line_, column_}; }

private:
    void skip_blanks();
    void skip_comment();
    void skip_line_comment(std::string_view mark);
    Token read_name();
    void check_length(const Token& name);
    Token read_symbol();
    Token refuse_character(Token token);
    Token read_directive();

    // lex_number.cpp
    Token read_number();
    Token read_hexadecimal(Token token);
    Token read_decimal(Token token);
    /// Whether there is one.
    bool skip_fraction();
    bool skip_exponent();
    bool at_float_suffix() const;
    void refuse_letters_behind(const Token& token, std::size_t start);
    Token read_integer(std::string_view digits, int base, Token token);
    Token read_octal(std::string_view digits, Token token);
    Token read_real(std::string_view digits, Token token);
    void apply_suffix(Token& token);

    // lex_text.cpp
    Token read_string();
    Token read_character();
    Token refuse_empty_character(Token token);
    /// A character of a string or a character constant, its escape resolved.
    char read_one();
    char read_escaped(const Location& start);
    char read_numeric_escape(int base, int most_digits, const Location& start);

    /// The characters from here on of which the predicate holds.
    std::string_view take_while(bool (*belongs)(char));
    bool at_end() const { return position_ >= text().size(); }
    char peek(std::size_t ahead = 0) const;
    void advance();
    std::int64_t take_unit_of_time();
    Token as_time(Token, std::int64_t nanoseconds);
    const std::string& text() const { return file_->text(); }

    std::shared_ptr<const SourceFile> file_;
    Reporter& reporter_;
    std::size_t position_ = 0, line_ = 1, column_ = 1;
    bool line_is_blank_so_far_ = true;
};

} // namespace placedpar
