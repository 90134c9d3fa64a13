#pragma once

#include "netlist/language/made_netlist.hpp"
#include "netlist/language/token.hpp"
#include "text/reporter.hpp"

#include <optional>

namespace placedpar {

/// Limits the length of a string, so that it can be printed on one line with every character escaped.
inline constexpr std::size_t longest_string = 2000;
/// Limits the length of a name, so that a statement with several names and subscripts can be printed on one line.
inline constexpr std::size_t longest_name = 255;

/// Splits the text of a netlist into tokens, and returns one token at a time. Reports text that is not a token, and
/// returns it as an illegal token. The language has only the comments of C, from slash star to star slash.
class Lexer {
public:
    /// `origins` is for a text that was made from another file: it gives the places of the tokens in that file. If
    /// `origins` is empty, the tokens have their places in `file`.
    Lexer(std::shared_ptr<const SourceFile> file, Reporter& reporter, std::vector<PartOrigin> origins = {});

    /// Returns the next token. At the end of the text, each call returns a token of kind `end`.
    Token next();
    /// Skips the rest of the line.
    void skip_line();
    /// Reads the file name in quotes after `#include`, in which `\` is an ordinary character. Returns nothing if no
    /// name follows on this line.
    std::optional<Token> read_file_name();
    /// Returns the current place, after the characters read so far.
    Location here() const { return origins_.empty() ? Location{file_, line_, column_} : origin(); }

private:
    Location origin() const;
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
    /// Skips the fraction of a number; returns whether there is one.
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
    /// Reads one character of a string or character constant, which may be written as an escape.
    char read_one();
    char read_escaped(const Location& start);
    char read_numeric_escape(int base, int most_digits, const Location& start);

    /// Takes characters while the predicate holds.
    std::string_view take_while(bool (*belongs)(char));
    bool at_end() const { return position_ >= text().size(); }
    char peek(std::size_t ahead = 0) const;
    void advance();
    std::int64_t take_unit_of_time();
    Token as_time(Token, std::int64_t nanoseconds);
    const std::string& text() const { return file_->text(); }

    std::shared_ptr<const SourceFile> file_;
    Reporter& reporter_;
    std::vector<PartOrigin> origins_;
    std::size_t position_ = 0, line_ = 1, column_ = 1;
    bool line_is_blank_so_far_ = true;
};

} // namespace placedpar
