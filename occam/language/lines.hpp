#pragma once

#include "occam/language/files.hpp"
#include "occam/language/words.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace placedpar::occam {

/// Holds the words of a line of a program and of the lines that continue it. The last word is of kind `end`.
struct Line {
    std::vector<Word> words;
    bool is_end = false; ///< true if there is no further line
};

/// Reads the lines of an occam file and of the files that it includes. Executes all directives except #USE, which the
/// parser executes.
class Lines {
public:
    /// REQUIRES: the file is the last of `reading.open`.
    Lines(Reading& reading, std::uint32_t file);

    /// Returns the next line that has words. After the last line, each call returns a line with `is_end`.
    Line next();

private:
    /// Describes an #IF whose #ENDIF has not been read. A branch is the lines after #IF, #ELIF or #ELSE.
    struct Condition {
        Place at;
        bool is_true = false;  ///< whether the lines of the present branch are read
        bool was_true = false; ///< whether the lines of this or an earlier branch are read
        bool has_else = false;
    };
    struct File {
        std::uint32_t index = 0;
        std::string_view rest = {}; ///< the part of the file's text that has not been read
        std::uint32_t line = 0;     ///< number of the last line that was taken
        std::uint32_t indentation =
            0; ///< indentation of the #INCLUDE that names the file, which is added to that of its lines
        std::vector<Condition> conditions = {};
    };
    struct TextLine {
        std::string_view text;
        Place start;
        std::uint32_t indentation = 0;
    };

    std::optional<TextLine> take_text();
    std::optional<TextLine> next_text(std::vector<Word>& words);
    bool is_left_out() const;
    void warn_of_tabs(const TextLine&);
    void continue_line(Line&, bool in_string);
    void close_file();

    void execute(std::string_view name, const TextLine&, std::vector<Word>& words);
    void execute_condition(std::string_view name, const TextLine&);
    void execute_else(const std::vector<Word>& words, bool is_else);
    void execute_include(const std::vector<Word>& words);
    void execute_define(const std::vector<Word>& words, bool is_defined);
    const Word* argument(const std::vector<Word>& words, WordKind, std::string_view what);

    Reading& reading_;
    WordScanner scanner_;
    std::vector<File> files_;
    std::optional<TextLine> held_; ///< next line, which was read to see whether it continues the previous line
    Place last_;                   ///< start of the last line that was read
    bool warned_of_tabs_ = false;
};

// Directives (directives.cpp)

/// Returns whether the directive is #IF, #ELIF, #ELSE or #ENDIF.
bool is_condition(std::string_view directive);
/// Returns whether the condition in `words`, after #IF or #ELIF, is true. Reports errors.
bool evaluate_condition(Reading&, const std::vector<Word>& words);
/// Executes #OPTION, which is followed by a string of letters.
void execute_option(Reading&, const Word& letters);
/// Executes #PRAGMA with the word that follows it.
void execute_pragma(Reading&, const Word& what);
/// Reports a directive that is not supported, or the text of #ERROR and #WARNING.
void execute_message(Reading&, std::string_view directive, std::string_view text, const Place&);

} // namespace placedpar::occam
