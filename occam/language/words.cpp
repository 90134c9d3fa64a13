#include "occam/language/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace placedpar::occam {

namespace {

constexpr std::array<std::string_view, 59> keywords = {
    "AFTER",  "ALT",    "AND",   "ANY",    "AT",      "BITAND", "BITNOT",   "BITOR",   "BOOL",      "BYTE",
    "CASE",   "CHAN",   "ELSE",  "FALSE",  "FOR",     "FROM",   "FUNCTION", "IF",      "IN",        "INLINE",
    "INT",    "INT16",  "INT32", "INT64",  "IS",      "MINUS",  "MOSTNEG",  "MOSTPOS", "NOT",       "OF",
    "OR",     "PAR",    "PLACE", "PLACED", "PLUS",    "PORT",   "PRI",      "PROC",    "PROCESSOR", "PROTOCOL",
    "REAL32", "REAL64", "REM",   "RESULT", "RETYPES", "ROUND",  "SEQ",      "SIZE",    "SKIP",      "STOP",
    "TIMER",  "TIMES",  "TRUE",  "TRUNC",  "VAL",     "VALOF",  "VECSPACE", "WHILE",   "WORKSPACE"};

constexpr std::array<std::string_view, 18> words_of_configurations = {
    "ARC", "CONFIG",  "CONNECT", "DO",   "EDGE", "HIGH", "HOST", "link", "LOW",
    "MAP", "MAPPING", "NETWORK", "NODE", "ON",   "ONTO", "SET",  "TO",   "WITH"};

constexpr std::array<std::string_view, 16> operator_words = {"AFTER", "AND",  "BITAND", "BITNOT", "BITOR", "FOR",
                                                             "FROM",  "IS",   "MINUS",  "NOT",    "OR",    "PLUS",
                                                             "REM",   "SIZE", "TIMES",  "RETYPES"};

/// Lists the symbols. Longer symbols come first: `:=` before `:`, so that `:=` is not read as two symbols.
constexpr std::array<std::string_view, 33> symbols = {
    ":=", "::", "<=", ">=", "<>", "<<", ">>", "><", "/\\", "\\/", "+", "-", "*", "/", "\\", "=", "<",
    ">",  "~",  "(",  ")",  "[",  "]",  ",",  ";",  ":",   "?",   "!", "&", "|", "@", "{",  "}"};

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f'); }
bool is_in_name(char c) { return is_letter(c) || is_digit(c) || c == '.' || c == '_'; }

unsigned value_of_digit(char c) {
    return static_cast<unsigned>(is_digit(c) ? c - '0' : std::toupper(static_cast<unsigned char>(c)) - 'A' + 10);
}

} // namespace

std::string_view directive_of(std::string_view line) {
    const std::string_view rest = line.substr(std::min(line.find_first_not_of(" \t\f\v"), line.size()));
    if (!rest.starts_with('#'))
        return "";
    std::size_t length = 1;
    while (length < rest.size() && is_letter(rest[length]))
        ++length;
    const std::string_view name = rest.substr(0, length);
    return std::ranges::all_of(name.substr(1), is_hexadecimal) ? "" : name;
}

std::span<const std::string_view> all_keywords() { return keywords; }

std::span<const std::string_view> configuration_words() { return words_of_configurations; }

bool is_keyword(std::string_view text) { return std::ranges::find(keywords, text) != keywords.end(); }

std::string describe(const Word& word) {
    switch (word.kind) {
    case WordKind::name: return fmt::format("the name \"{}\"", word.text);
    case WordKind::keyword: return fmt::format("the keyword \"{}\"", word.text);
    case WordKind::integer:
    case WordKind::real: return fmt::format("the number {}", word.text);
    case WordKind::character: return fmt::format("the character {}", word.text);
    case WordKind::string: return "a string";
    case WordKind::end: return "the end of the line";
    default: return fmt::format("\"{}\"", word.text);
    }
}

bool continues_line(const Word& word) {
    if (word.kind == WordKind::keyword)
        return std::ranges::find(operator_words, word.text) != operator_words.end();
    static constexpr std::array<std::string_view, 8> ends = {")", "]", ":", "?", "!", "&", "}", "@"};
    return word.kind == WordKind::symbol && std::ranges::find(ends, word.text) == ends.end();
}

bool WordScanner::scan(std::string_view line, Place start, std::uint32_t indentation, std::vector<Word>& words) {
    line_ = line;
    start_ = start;
    position_ = counted_ = 0;
    blanks_ = 0;
    indentation_ = indentation;
    return scan_rest(words);
}

bool WordScanner::continue_string(std::string_view line, Place start, std::uint32_t indentation,
                                  std::vector<Word>& words) {
    line_ = line;
    start_ = start;
    position_ = counted_ = 0;
    blanks_ = 0;
    indentation_ = indentation;
    skip_blanks();
    if (at(position_) != '*')
        error(position_, "a string that ends its line with \"*\" must begin the next line with \"*\"");
    else
        ++position_;
    return take_string(words.back()) || scan_rest(words);
}

bool WordScanner::scan_rest(std::vector<Word>& words) {
    while (true) {
        skip_blanks();
        if (position_ >= line_.size() || line_.substr(position_).starts_with("--"))
            return false;
        if (scan_word(words))
            return true;
    }
}

/// Skips blanks. Counts the columns up to the next word, which are its indentation.
void WordScanner::skip_blanks() {
    while (position_ < line_.size() &&
           (at(position_) == ' ' || at(position_) == '\t' || at(position_) == '\f' || at(position_) == '\v'))
        ++position_;
    for (; counted_ < position_; ++counted_)
        blanks_ = at(counted_) == '\t' ? blanks_ / 8 * 8 + 8 : blanks_ + 1;
}

/// Returns whether the word is a string that continues on the next line.
bool WordScanner::scan_word(std::vector<Word>& words) {
    Word& word = words.emplace_back();
    const std::size_t start = position_;
    word.at = {start_.file, start_.line, static_cast<std::uint32_t>(start + 1)};
    word.indentation = indentation_ + blanks_;
    bool goes_on = false;
    const char c = at(position_);
    if (is_letter(c))
        take_name(word);
    else if (is_digit(c))
        take_digits_of(word);
    else if (const auto directive = directive_of(line_.substr(start)); words.size() == 1 && !directive.empty()) {
        word.kind = WordKind::directive;
        position_ += directive.size();
    } else if (c == '#')
        take_hexadecimal(word);
    else if (c == '\'')
        take_character(word);
    else if (c == '"') {
        word.kind = WordKind::string;
        ++position_;
        goes_on = take_string(word);
    } else
        take_symbol(word);
    word.text = line_.substr(start, position_ - start);
    if (word.kind == WordKind::name && is_keyword(word.text))
        word.kind = WordKind::keyword;
    return goes_on;
}

void WordScanner::take_name(Word& word) {
    word.kind = WordKind::name;
    for (; is_in_name(at(position_)); ++position_)
        if (at(position_) == '_' && word.kind == WordKind::name) {
            error(position_, "a name has letters, digits and dots only", "write a dot in place of \"_\"");
            word.kind = WordKind::illegal;
        }
}

bool WordScanner::digit_at(std::size_t position) const { return is_digit(at(position)); }

void WordScanner::take_digits_of(Word& word) {
    word.kind = WordKind::integer;
    while (digit_at(position_))
        ++position_;
    if (at(position_) == '.' && digit_at(position_ + 1)) {
        word.kind = WordKind::real;
        for (++position_; digit_at(position_);)
            ++position_;
        const bool has_sign = at(position_ + 1) == '+' || at(position_ + 1) == '-';
        if (at(position_) == 'E' && has_sign && digit_at(position_ + 2))
            for (position_ += 2; digit_at(position_);)
                ++position_;
        else if (at(position_) == 'E' || at(position_) == 'e') {
            error(position_, "an exponent has a capital E, a sign and digits", "write the number like 1.0E+20");
            word.kind = WordKind::illegal;
        }
    }
    if (!is_in_name(at(position_)))
        return;
    if (word.kind != WordKind::illegal)
        error(position_,
              at(position_) == '.' ? "a number with a decimal point needs digits on both sides of the point"
                                   : "a letter follows a number",
              "a name begins with a letter");
    word.kind = WordKind::illegal;
    while (is_in_name(at(position_)))
        ++position_;
}

void WordScanner::take_hexadecimal(Word& word) {
    word.kind = WordKind::integer;
    const std::size_t start = ++position_;
    while (is_hexadecimal(at(position_)))
        ++position_;
    if (position_ != start && !is_in_name(at(position_)))
        return;
    while (is_in_name(at(position_)))
        ++position_;
    error(start - 1, "\"#\" begins a hexadecimal number, such as #2A, or a directive at the start of a line");
    word.kind = WordKind::illegal;
}

void WordScanner::take_symbol(Word& word) {
    word.kind = WordKind::symbol;
    const std::string_view rest = line_.substr(position_);
    const auto found = std::ranges::find_if(symbols, [&](std::string_view each) { return rest.starts_with(each); });
    if (found == symbols.end())
        refuse_byte(word);
    else
        position_ += found->size();
}

void WordScanner::refuse_byte(Word& word) {
    word.kind = WordKind::illegal;
    const auto byte = static_cast<unsigned char>(at(position_));
    error(position_, byte > 0x20 && byte < 0x7f
                         ? fmt::format("occam has no symbol \"{}\"", static_cast<char>(byte))
                         : fmt::format("the byte 0x{:02x} is allowed only in a string or a comment", unsigned{byte}));
    while (position_ < line_.size() && (static_cast<unsigned char>(line_[position_]) == byte || byte > 0x7f) &&
           (byte <= 0x7f || static_cast<unsigned char>(line_[position_]) > 0x7f))
        ++position_;
}

void WordScanner::take_character(Word& word) {
    word.kind = WordKind::character;
    const std::size_t start = position_++;
    if (at(position_) == '*')
        take_escape(word.bytes, false);
    else if (position_ < line_.size() && at(position_) != '\'')
        word.bytes += line_[position_++];
    if (at(position_) == '\'' && word.bytes.size() == 1) {
        ++position_;
        return;
    }
    word.kind = WordKind::illegal;
    error(start, "a character is written between two single quotes: 'a', '*n', '*''",
          "write text between double quotes");
    if (const auto end = line_.find('\'', start + 1); end != std::string_view::npos)
        position_ = std::max(position_, end + 1);
}

/// Reads an escape, which begins with `*`.
void WordScanner::take_escape(std::string& bytes, bool first_of_string) {
    static constexpr std::string_view letters = "cntsCNTS'\"*";
    static constexpr std::string_view meanings = "\r\n\t \r\n\t '\"*";
    const char c = at(++position_);
    if (const auto known = letters.find(c); known != std::string_view::npos && c != '\0') {
        bytes += meanings[known];
        ++position_;
    } else if (c == '#' && is_hexadecimal(at(position_ + 1)) && is_hexadecimal(at(position_ + 2))) {
        bytes += static_cast<char>(value_of_digit(at(position_ + 1)) * 16 + value_of_digit(at(position_ + 2)));
        position_ += 3;
    } else if ((c == 'l' || c == 'L') && first_of_string) {
        bytes += '\0';
        ++position_;
    } else {
        error(position_ - 1,
              c == 'l' || c == 'L' ? std::string("\"*l\", the length, can only be the first character of a string")
                                   : fmt::format("\"*{}\" is not an escape of a string",
                                                 position_ < line_.size() ? std::string(1, c) : std::string()),
              "escapes are *c *n *t *s *' *\" ** and *#0D");
        bytes += '?';
        position_ += position_ < line_.size() ? 1 : 0;
    }
}

/// Returns whether the string continues on the next line.
bool WordScanner::take_string(Word& word) {
    while (position_ < line_.size()) {
        if (at(position_) == '"') {
            ++position_;
            return false;
        }
        if (at(position_) != '*')
            word.bytes += line_[position_++];
        else if (line_.find_first_not_of(" \t", position_ + 1) == std::string_view::npos) {
            position_ = line_.size();
            return true;
        } else
            take_escape(word.bytes, word.bytes.empty());
    }
    error(line_.size(), "the string is not closed",
          "end it with \", or end this line with \"*\" and begin the next line with \"*\"");
    word.kind = WordKind::illegal;
    return false;
}

void WordScanner::error(std::size_t position, std::string message, std::string hint) {
    reporter_.error(program_.location({start_.file, start_.line, static_cast<std::uint32_t>(position + 1)}),
                    std::move(message), std::move(hint));
}

} // namespace placedpar::occam
