#include "occam/language/lines.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar::occam {

namespace {

/// Evaluates the condition of an #IF: NOT, AND, OR, DEFINED (X), a = b, TRUE, FALSE.
class ConditionReader {
public:
    ConditionReader(Reading& reading, const std::vector<Word>& words) : reading_(reading), words_(words) {}

    bool evaluate() {
        const bool value = disjunction();
        if (position_ < words_.size())
            refuse("the end of the line is expected");
        return value && !failed_;
    }

private:
    bool accept(std::string_view word) {
        const bool found = position_ < words_.size() && (words_[position_].is_word(word) || words_[position_].is(word));
        position_ += found ? 1 : 0;
        return found;
    }
    void expect(std::string_view word) {
        if (!accept(word))
            refuse(fmt::format("\"{}\" is expected", word));
    }
    void refuse(const std::string& message) {
        const Word& at = words_[std::min(position_, words_.size() - 1)];
        if (!failed_ && at.kind != WordKind::illegal)
            reading_.reporter.error(reading_.location(at.at),
                                    message + " in the condition of " + std::string(words_.front().text),
                                    "write a condition such as DEFINED (X), with NOT, AND, OR and =");
        failed_ = true;
        position_ = words_.size();
    }
    bool disjunction() {
        bool value = conjunction();
        while (accept("OR"))
            value |= conjunction();
        return value;
    }
    bool conjunction() {
        bool value = term();
        while (accept("AND"))
            value &= term();
        return value;
    }
    bool term() {
        bool is_negated = false;
        while (accept("NOT"))
            is_negated = !is_negated;
        return plain_term() != is_negated;
    }
    bool plain_term() {
        if (accept("DEFINED"))
            return defined();
        if (accept("("))
            return in_parentheses();
        const std::string left = value();
        if (!accept("=") && !accept("<>"))
            return left == "TRUE";
        const bool is_equal = words_[position_ - 1].text == "=";
        return (left == value()) == is_equal;
    }
    bool in_parentheses() {
        if (++depth_ > deepest_nesting)
            refuse(fmt::format("at most {} nested parentheses are allowed", deepest_nesting));
        const bool value = disjunction();
        --depth_;
        expect(")");
        return value;
    }
    bool defined() {
        expect("(");
        const bool value = position_ < words_.size() && reading_.defined.contains(std::string(words_[position_].text));
        ++position_;
        expect(")");
        return value;
    }
    std::string value() {
        if (position_ >= words_.size() || words_[position_].kind == WordKind::symbol) {
            refuse("a name or a value is expected");
            return "";
        }
        const Word& word = words_[position_++];
        const auto known = reading_.defined.find(std::string(word.text));
        if (word.kind == WordKind::name && known != reading_.defined.end())
            return known->second;
        return word.kind == WordKind::string ? word.bytes : std::string(word.text);
    }

    Reading& reading_;
    const std::vector<Word>& words_;
    std::size_t position_ = 1;
    std::size_t depth_ = 0;
    bool failed_ = false;
};

} // namespace

bool is_condition(std::string_view directive) {
    return directive == "#IF" || directive == "#ELIF" || directive == "#ELSE" || directive == "#ENDIF";
}

bool evaluate_condition(Reading& reading, const std::vector<Word>& words) {
    return ConditionReader(reading, words).evaluate();
}

void execute_option(Reading& reading, const Word& letters) {
    for (const char letter : letters.bytes)
        switch (letter) {
        case 'A': reading.source_options.alias_checks = false; break;
        case 'N': reading.source_options.usage_checks = false; break;
        case 'K': reading.source_options.range_checks = false; break;
        case 'U': reading.source_options.run_time_checks = false; break;
        case 'V': reading.source_options.vector_space = false; break;
        case 'E': // no extended types, debugging, warnings, code in assembler: without meaning here
        case 'G':
        case 'W':
        case 'Y':
        case ' ': break;
        default:
            reading.reporter.warning(
                reading.location(letters.at), fmt::format("#OPTION has no letter \"{}\"", letter),
                "the letters are A: no alias checks, N: no usage checks, K: no range checks, U: no checks at run "
                "time, V: arrays in the workspace");
        }
}

void execute_pragma(Reading& reading, const Word& what) {
    static constexpr std::array<std::string_view, 5> ignored = {"COMMENT", "LINKAGE", "PERMITALIASES", "SHARED",
                                                                "TRANSLATE"};
    if (what.text == "EXTERNAL")
        reading.reporter.error(reading.location(what.at), "foreign code is not supported: #PRAGMA EXTERNAL");
    else if (std::ranges::find(ignored, what.text) == ignored.end())
        reading.reporter.warning(reading.location(what.at), fmt::format("#PRAGMA {} is ignored", what.text));
}

void execute_message(Reading& reading, std::string_view directive, std::string_view text, const Place& at) {
    static const std::vector<std::string> known = {"#INCLUDE", "#USE",   "#OPTION", "#PRAGMA", "#COMMENT",
                                                   "#DEFINE",  "#UNDEF", "#IF",     "#ELIF",   "#ELSE",
                                                   "#ENDIF",   "#ERROR", "#WARNING"};
    const auto first = std::min(text.find_first_not_of(" \t"), text.size());
    const std::string message = fmt::format("{}: {}", directive, text.substr(first));
    if (directive == "#WARNING")
        reading.reporter.warning(reading.location(at), message);
    else if (directive == "#ERROR")
        reading.reporter.error(reading.location(at), message);
    else if (directive == "#IMPORT")
        reading.reporter.error(reading.location(at), "foreign code is not supported: #IMPORT");
    else
        reading.reporter.error(
            reading.location(at),
            unknown_name("directive", directive, known, "the directives are #INCLUDE, #USE, #OPTION, #PRAGMA, #IF"));
}

} // namespace placedpar::occam
