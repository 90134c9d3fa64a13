#include "netlist/language/parser.hpp"

#include "netlist/language/characters.hpp"

#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace placedpar {

std::span<const std::string_view> reserved_words() {
    static constexpr std::array<std::string_view, 17> words{
        "val", "define", "connection", "connect", "process", "input", "output", "use",      "place",
        "rep", "if",     "else",       "for",     "to",      "by",    "on",     "interface"};
    return words;
}

bool is_reserved(std::string_view word) { return std::ranges::find(reserved_words(), word) != reserved_words().end(); }

bool can_be_a_name(std::string_view text) {
    return !text.empty() && starts_name(text.front()) && std::ranges::all_of(text, in_name) && !is_reserved(text);
}

const std::vector<std::string>& statement_words() {
    static const std::vector<std::string> words{"val",    "define", "connection", "connect", "process", "input",
                                                "output", "use",    "place",      "rep",     "if"};
    return words;
}

namespace {

/// Returns a hint for a reserved word that cannot begin a statement.
std::string_view hint_at_statement(std::string_view word) {
    return word == "else"  ? "\"else\" must follow an \"if\""
           : word == "for" ? "a repeated statement begins with rep: rep i = 0 for n statement"
                           : "";
}

bool is_statement_word(const Token& token) {
    const auto& words = statement_words();
    return token.is_word("else") ||
           (token.kind == TokenKind::name && std::ranges::find(words, token.text) != words.end());
}

} // namespace

std::string word_meant(const std::string& word, const std::vector<std::string>& words) {
    auto nearest = nearest_name(word, words);
    std::size_t most = nearest.size() < 6 ? 1 : 2;
    return edit_distance(lower_case(word), nearest) <= most ? nearest : "";
}

std::string word_meant(const std::string& word) {
    return lower_case(word) == "processor" || word == "PROCESS" ? "" : word_meant(word, statement_words());
}

Parser::Nesting::Nesting(Parser& owner) : parser(owner) {
    if (++parser.depth_ > deepest_nesting)
        parser.reporter_.give_up(
            parser.tokens_.peek().at,
            fmt::format("the nesting is too deep: at most {} levels are allowed", deepest_nesting));
}

void Parser::refuse(const Location& at, std::string message, std::string hint) {
    if (tokens_.peek().kind == TokenKind::illegal) // the lexer has reported it
        throw StatementRefused{};
    auto meant = misspelt_ ? word_meant(misspelt_->text) : "";
    if (meant.empty())
        reporter_.error(at, std::move(message), std::move(hint));
    else
        reporter_.error(misspelt_->at, fmt::format("no statement begins with \"{}\"", misspelt_->text),
                        fmt::format("did you mean \"{}\"?", meant));
    throw StatementRefused{};
}

bool Parser::accept(std::string_view symbol) {
    if (!tokens_.peek().is(symbol))
        return false;
    tokens_.take();
    return true;
}

void Parser::expect(std::string_view symbol, std::string_view where) {
    if (!accept(symbol))
        refuse_missing(symbol, where);
}

void Parser::expect_word(std::string_view word, std::string_view where) {
    if (!tokens_.peek().is_word(word))
        refuse_missing(word, where);
    tokens_.take();
}

void Parser::refuse_missing(std::string_view what, std::string_view where) {
    const auto& here = tokens_.peek();
    refuse(gap(), fmt::format("\"{}\" is missing {}: found {}", what, where, describe(here)));
}

Location Parser::gap() {
    bool ends = tokens_.peek().kind == TokenKind::end;
    return tokens_.behind_last().file && (ends || on_another_line()) ? tokens_.behind_last() : tokens_.peek().at;
}

bool Parser::on_another_line() {
    const auto& last = tokens_.behind_last();
    const auto& next = tokens_.peek().at;
    return last.file != next.file || last.line != next.line;
}

/// Returns whether the next token cannot belong to the current statement: it ends a block or the file, or begins a
/// statement.
bool Parser::statement_is_over() {
    const auto& next = tokens_.peek();
    return next.kind == TokenKind::end || next.is("}") || is_statement_word(next);
}

/// Takes ";". If only the ";" is missing, reports this, and parsing continues with the next statement. If the next
/// token belongs to the statement, refuses the token.
void Parser::expect_semicolon(std::string_view statement) {
    if (accept(";"))
        return;
    const auto& next = tokens_.peek();
    bool illegal = next.kind == TokenKind::illegal || !(on_another_line() || statement_is_over());
    if (illegal)
        refuse(next.at, fmt::format("illegal token in {} statement: {}", with_article(statement), describe(next)),
               "end the statement with \";\"");
    reporter_.error(tokens_.behind_last(),
                    fmt::format("\";\" is missing at the end of {} statement", with_article(statement)));
    if (next.kind != TokenKind::name && !statement_is_over())
        throw StatementRefused{};
}

Token Parser::expect_name(std::string_view what) {
    const auto& token = tokens_.peek();
    if (token.kind != TokenKind::name)
        refuse(token.at, fmt::format("the name of {} is missing: found {}", what, describe(token)));
    if (is_reserved(token.text))
        refuse(token.at,
               fmt::format("{} is a word of the language and cannot be the name of {}", describe(token), what));
    return tokens_.take();
}

Statements Parser::parse_netlist() {
    Statements statements;
    while (tokens_.peek().kind != TokenKind::end) {
        if (tokens_.peek().is("}")) {
            reporter_.error(tokens_.take().at, "\"}\" closes no block");
            continue;
        }
        parse_into(statements);
    }
    return statements;
}

void Parser::parse_into(Statements& statements) try {
    statements.push_back(parse_statement());
} catch (const StatementRefused&) {
    recover();
}

/// Skips tokens up to and including the next `;`. Skips whole blocks and array constants, but does not leave the
/// current block.
void Parser::recover() {
    int arrays = std::exchange(arrays_open_, 0);
    for (int open = 0; tokens_.peek().kind != TokenKind::end;) {
        bool closes = tokens_.peek().is("}") && open == 0;
        if (closes && arrays == 0)
            return;
        auto token = tokens_.take();
        if (closes && arrays-- > 0)
            continue;
        if (token.is("{"))
            ++open;
        else if (token.is("}") && --open == 0)
            return;
        else if (token.is(";") && open == 0)
            return;
    }
}

Statement Parser::parse_statement() {
    const auto& first = tokens_.peek();
    misspelt_.reset();
    if (first.is("{"))
        return parse_block();
    if (first.is(";"))
        return {tokens_.take().at, BlockStatement{}};
    if (first.kind != TokenKind::name)
        refuse(first.at, fmt::format("no statement begins with {}", describe(first)));
    if (is_reserved(first.text))
        return parse_keyword_statement(first);
    return parse_declaration_or_setting(first);
}

Statement Parser::parse_declaration_or_setting(const Token& first) {
    // "fault" is not reserved, since old netlists may use it as a name
    if (first.is_word("fault") && tokens_.peek(1).kind == TokenKind::name && !types_.contains("fault"))
        return parse_fault();
    if (!types_.contains(first.text))
        misspelt_ = first;
    bool declares = first.text == "PROCESS" || behind_attributes_comes_name();
    auto statement = declares ? parse_declaration() : parse_setting();
    misspelt_.reset();
    return statement;
}

Statement Parser::parse_keyword_statement(const Token& word) {
    using Parse = Statement (Parser::*)();
    static const std::map<std::string_view, Parse> forms{
        {"val", &Parser::parse_val},
        {"define", &Parser::parse_define},
        {"connection", &Parser::parse_connection},
        {"input", &Parser::parse_edge_channel},
        {"output", &Parser::parse_edge_channel},
        {"process", &Parser::parse_declaration},
        {"connect", &Parser::parse_connect},
        {"use", &Parser::parse_use},
        {"place", &Parser::parse_place},
        {"rep", &Parser::parse_rep},
        {"if", &Parser::parse_if},
    };
    if (auto form = forms.find(word.text); form != forms.end())
        return (this->*form->second)();
    refuse(word.at, fmt::format("no statement begins with \"{}\"", word.text),
           std::string(hint_at_statement(word.text)));
}

Statement Parser::parse_block() {
    Nesting nesting(*this);
    auto opening = tokens_.take();
    BlockStatement block;
    while (!tokens_.peek().is("}")) {
        if (tokens_.peek().kind == TokenKind::end)
            reporter_.give_up(tokens_.peek().at, "\"}\" is missing at the end of the file",
                              {{"the block begins here", opening.at}});
        parse_into(block.statements);
    }
    tokens_.take();
    return {opening.at, std::move(block)};
}

std::unique_ptr<Statement> Parser::parse_body(std::string_view whose) {
    if (tokens_.peek().kind == TokenKind::end || tokens_.peek().is("}"))
        refuse(tokens_.peek().at, fmt::format("the statement of \"{}\" is missing", whose));
    if (tokens_.peek().is("{"))
        return std::make_unique<Statement>(parse_block());
    Nesting nesting(*this);
    return std::make_unique<Statement>(parse_statement());
}

} // namespace placedpar
