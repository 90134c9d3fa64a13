#pragma once

#include "occam/language/tree.hpp"

#include "text/reporter.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

enum class WordKind : std::uint8_t {
    name,
    keyword,
    integer, ///< `42`, `#2A`
    real,    ///< `1.5`, `1.0E+20`
    character,
    string,
    symbol,
    directive, ///< `#USE`, at the start of a line
    illegal,   ///< text that is not a word; it has been reported as an error
    end        ///< end of a line, or of the file
};

/// Holds a word of a line of an occam program. `text` points into the source file.
struct Word {
    WordKind kind = WordKind::end;
    std::string_view text = {};
    Place at = {};
    std::uint32_t indentation = 0; ///< column of the word, from 0; a tab counts as the blanks that it replaces, and the
                                   ///< indentation of the file's #INCLUDE is added
    std::string bytes = {}; ///< for a character or string: its bytes, without escapes; for #USE: the name of the file

    bool is(std::string_view symbol) const { return kind == WordKind::symbol && text == symbol; }
    /// Returns whether this is the keyword `word`, or a name with this text. WordScanner reads keywords of later
    /// versions of occam, such as STEP, as names.
    bool is_word(std::string_view word) const {
        return (kind == WordKind::keyword || kind == WordKind::name) && text == word;
    }
};

/// Returns whether the text is a keyword of occam 2. A keyword of a later version, such as STEP, does not count, so
/// that old programs can use it as a name.
bool is_keyword(std::string_view text);
std::span<const std::string_view> all_keywords();
/// Returns the words that have a meaning only in configurations, such as NODE. WordScanner reads them as names.
std::span<const std::string_view> configuration_words();
/// Returns a text for messages, such as `the name "x"`, `the keyword "SEQ"` or `the end of the line`.
std::string describe(const Word&);
/// Returns whether a line that ends with this word continues on the next line, as after an operator, `,`, `:=` or `IS`.
bool continues_line(const Word&);

/// Returns the directive with which a line begins, such as "#USE"; "" if there is none. A hexadecimal number such as
/// #FEED is not a directive.
std::string_view directive_of(std::string_view line);

/// Splits lines of an occam program into words. Reports text that is not a word.
class WordScanner {
public:
    WordScanner(const Program& program, Reporter& reporter) : program_(program), reporter_(reporter) {}

    /// Appends the words of a line to `words`. `indentation` is added to the indentation of each word. Returns whether
    /// the line ends with a `*` within a string; the caller then calls continue_string() with the next line.
    bool scan(std::string_view line, Place start, std::uint32_t indentation, std::vector<Word>& words);
    /// Scans a line that continues a string. REQUIRES: the string is the last of `words`.
    bool continue_string(std::string_view line, Place start, std::uint32_t indentation, std::vector<Word>& words);

private:
    bool scan_rest(std::vector<Word>& words);
    bool scan_word(std::vector<Word>& words);
    void take_name(Word&);
    void take_digits_of(Word&);
    void take_hexadecimal(Word&);
    void take_symbol(Word&);
    void take_character(Word&);
    bool take_string(Word&);
    void take_escape(std::string& bytes, bool first_of_string);
    void refuse_byte(Word&);
    void skip_blanks();
    void error(std::size_t position, std::string message, std::string hint = "");
    bool digit_at(std::size_t position) const;
    char at(std::size_t position) const { return position < line_.size() ? line_[position] : '\0'; }

    const Program& program_;
    Reporter& reporter_;
    std::string_view line_;
    Place start_;
    std::size_t position_ = 0;
    std::uint32_t blanks_ = 0; ///< number of blanks before position_, if the line has only blanks there
    std::uint32_t indentation_ = 0;
    std::size_t counted_ = 0; ///< number of bytes of the line that blanks_ counts
};

} // namespace placedpar::occam
