#include "occam/language/parser.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar::occam {

namespace {

struct UnreadWord {
    std::string_view word, language;
};
constexpr std::string_view occam_pi = "occam-pi", occam_1 = "occam 1", assembler = "code in assembler";
constexpr std::array<UnreadWord, 18> unread_words = {{{"MOBILE", occam_pi},
                                                      {"SHARED", occam_pi},
                                                      {"CLAIM", occam_pi},
                                                      {"FORK", occam_pi},
                                                      {"FORKING", occam_pi},
                                                      {"BARRIER", occam_pi},
                                                      {"SYNC", occam_pi},
                                                      {"REC", occam_pi},
                                                      {"RECURSIVE", occam_pi},
                                                      {"CLONE", occam_pi},
                                                      {"ASM", assembler},
                                                      {"GUY", assembler},
                                                      {"VAR", occam_1},
                                                      {"DEF", occam_1},
                                                      {"NOW", occam_1},
                                                      {"WAIT", occam_1},
                                                      {"VALUE", occam_1},
                                                      {"EXTERNAL", occam_1}}};

const UnreadWord* unread_word(std::string_view text) {
    const auto found = std::ranges::find(unread_words, text, &UnreadWord::word);
    return found == unread_words.end() ? nullptr : &*found;
}

} // namespace

Parser::Nesting::Nesting(Parser& parser) : reading(parser.reading_) {
    if (++reading.depth > deepest_nesting)
        reading.reporter.give_up(
            parser.at(parser.peek()),
            fmt::format("the nesting is too deep: at most {} levels are allowed", deepest_nesting));
}

Parser::Parser(Reading& reading, std::uint32_t file) : reading_(reading), lines_(reading, file) { next_line(); }

const Word& Parser::peek(std::size_t ahead) const {
    return line_.words[std::min(position_ + ahead, line_.words.size() - 1)];
}

const Word& Parser::take() {
    const Word& word = peek();
    last_ = word;
    if (position_ + 1 < line_.words.size())
        ++position_;
    return word;
}

void Parser::next_line() {
    line_ = lines_.next();
    position_ = 0;
    ++lines_taken_;
}

bool Parser::accept(std::string_view symbol) {
    const bool found = peek().is(symbol);
    if (found)
        take();
    return found;
}

bool Parser::accept_word(std::string_view word) {
    const bool found = peek().is_word(word);
    if (found)
        take();
    return found;
}

void Parser::refuse(const Word& at_word, std::string message, std::string hint) {
    if (at_word.kind != WordKind::illegal) // otherwise the scanner has reported an error
        reading_.reporter.error(at(at_word), std::move(message), std::move(hint));
    throw LineRefused{};
}

void Parser::refuse_unread(const Word& word, std::string_view where) {
    const UnreadWord* known = unread_word(word.text);
    if (!known)
        refuse(word, fmt::format("{} is expected: found {}", where, describe(word)));
    if (!reading_.refused.emplace(word.text).second)
        throw LineRefused{};
    refuse(word, fmt::format("{} {} {}, which is not supported", word.text,
                             known->language == assembler ? "begins" : "belongs to", known->language));
}

void Parser::expect(std::string_view symbol, std::string_view where) {
    if (!accept(symbol))
        refuse(peek(), fmt::format("\"{}\" is missing {}: found {}", symbol, where, describe(peek())));
}

void Parser::expect_word(std::string_view word, std::string_view where) {
    if (!accept_word(word))
        refuse(peek(), fmt::format("\"{}\" is missing {}: found {}", word, where, describe(peek())));
}

std::string Parser::expect_name(std::string_view what) {
    const Word& word = peek();
    if (word.kind == WordKind::keyword)
        refuse(word, fmt::format("\"{}\" is a word of the language and cannot be the name of {}", word.text, what));
    if (word.kind != WordKind::name)
        refuse(word, fmt::format("the name of {} is missing: found {}", what, describe(word)));
    return std::string(take().text);
}

/// Expects the end of the line, and continues with the next line.
void Parser::end_line(std::string_view behind) {
    const Word& word = peek();
    if (word.kind != WordKind::end)
        refuse(word, fmt::format("the end of the line is expected after {}: found {}", behind, describe(word)));
    next_line();
}

std::vector<DeclarationBox> Parser::parse_file() {
    std::vector<DeclarationBox> declarations;
    while (!is_at_end()) {
        const Word first = peek();
        const std::size_t line = lines_taken_;
        try {
            if (first.indentation != 0 && !indentation_in_doubt_) {
                reading_.reporter.error(at(first), "an outermost declaration of a file must not be indented");
                indentation_in_doubt_ = true;
            }
            const bool is_remainder = first.is(":") || first.indentation != 0;
            if (is_remainder && reading_.reporter.failed()) // the line may belong to a refused statement
                throw LineRefused{};
            if (first.is(":"))
                refuse(first, "this \":\" ends nothing", "the PROC or FUNCTION has ended above");
            if (is_configuration_part())
                parse_configuration_part(declarations);
            else if (is_declaration(false))
                parse_with_start(declarations);
            else
                refuse_statement(first);
        } catch (const LineRefused&) {
            recover(first.indentation, line);
        }
    }
    return declarations;
}

Parsed parse(std::shared_ptr<const SourceFile> file, const ParseOptions& options, Reporter& reporter) {
    Parsed parsed;
    parsed.program = std::make_unique<Program>();
    Reading reading{.program = *parsed.program, .options = options, .reporter = reporter};
    for (const std::string& name : options.defined)
        reading.defined[name] = "";
    std::error_code error;
    reading.open.push_back({std::filesystem::weakly_canonical(file->path(), error).string(), {}});
    try {
        parsed.program->declarations = Parser(reading, add_file(reading, std::move(file), {})).parse_file();
        if (auto text = options.built_in ? options.built_in("predef.lib") : std::nullopt) {
            auto library = std::make_shared<const SourceFile>("<predef.lib>", std::move(*text));
            parsed.program->routines = Parser(reading, add_file(reading, std::move(library), {})).parse_file();
        }
    } catch (const GiveUp&) { // the last diagnostic states the reason
    }
    parsed.options = reading.source_options;
    return parsed;
}

} // namespace placedpar::occam
