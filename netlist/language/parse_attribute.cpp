#include "netlist/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar {

std::span<const std::string_view> parameter_types() {
    static constexpr std::array<std::string_view, 7> types{"int",   "char",   "short",   "long",
                                                           "float", "double", "unsigned"};
    return types;
}

namespace {

bool is_parameter_type(std::string_view word) {
    return std::ranges::find(parameter_types(), word) != parameter_types().end();
}

} // namespace

/// Returns whether a name follows the parentheses. In `T800 (memory = 1M) root;` it does; in `root (n = 4);` it does
/// not.
bool Parser::behind_attributes_comes_name() {
    if (tokens_.peek(1).kind == TokenKind::name)
        return true;
    if (!tokens_.peek(1).is("("))
        return false;
    int open = 0;
    for (std::size_t i = 1;; ++i) {
        const auto& token = tokens_.peek(i);
        if (token.kind == TokenKind::end || token.is(";"))
            return false;
        if (token.is("("))
            ++open;
        else if (token.is(")") && --open == 0)
            return tokens_.peek(i + 1).kind == TokenKind::name;
    }
}

/// Parses an optional list of attributes in parentheses.
std::vector<Attribute> Parser::parse_attributes() {
    std::vector<Attribute> attributes;
    if (!accept("("))
        return attributes;
    if (accept(")"))
        return attributes;
    do
        attributes.push_back(parse_attribute());
    while (accept(","));
    expect(")", "after the attributes");
    return attributes;
}

Attribute Parser::parse_attribute() {
    Nesting nesting(*this);
    auto name = expect_name("an attribute");
    Attribute attribute{name.text, name.at, nullptr, {}};
    while (accept(".")) // location.code = ...
        attribute.name.append(".").append(expect_name("an attribute").text);
    if (tokens_.peek().is("("))
        attribute.group = parse_attributes();
    else if (accept("="))
        attribute.value = parse_expression();
    else
        refuse(tokens_.peek().at,
               fmt::format("the attribute \"{}\" has no value: found {}", attribute.name, describe(tokens_.peek())),
               fmt::format("write {} = ...", attribute.name));
    return attribute;
}

DeclarationAttributes Parser::parse_declaration_attributes() {
    DeclarationAttributes result;
    if (!accept("(") || accept(")"))
        return result;
    do
        if (tokens_.peek().is_word("interface"))
            parse_interface_once(result);
        else
            result.attributes.push_back(parse_process_attribute());
    while (accept(","));
    expect(")", "after the attributes");
    return result;
}

/// Parses an attribute of a process. Refuses a misspelt `interface` here: the channels and parameters that follow it
/// would otherwise cause misleading errors.
Attribute Parser::parse_process_attribute() {
    const auto& name = tokens_.peek();
    bool has_parts = name.kind == TokenKind::name && tokens_.peek(1).is("(");
    if (has_parts && !word_meant(name.text, {"interface"}).empty())
        refuse(name.at, fmt::format("unknown attribute \"{}\"", name.text), "did you mean \"interface\"?");
    return parse_attribute();
}

void Parser::parse_interface_once(DeclarationAttributes& attributes) {
    auto word = tokens_.take();
    if (attributes.interface) {
        reporter_.error(
            word.at, "the attribute \"interface\" is given twice", "",
            {{fmt::format("given first at line {}", attributes.interface_at.line), attributes.interface_at}});
        throw StatementRefused{};
    }
    attributes.interface_at = word.at;
    attributes.interface = parse_interface();
}

/// Parses `(input in, out2, output out[3], int n = 3)`. An entry without a type has the type of the entry before it.
std::vector<InterfaceEntry> Parser::parse_interface() {
    std::vector<InterfaceEntry> entries;
    expect("(", "after \"interface\"");
    if (accept(")"))
        return entries;
    std::optional<EntryType> type;
    do {
        if (auto here = parse_entry_type())
            type = here;
        else if (!type || tokens_.peek(1).kind == TokenKind::name)
            refuse_entry();
        entries.push_back(parse_entry(*type));
    } while (accept(","));
    expect(")", "after the interface");
    return entries;
}

void Parser::refuse_entry() {
    static const std::vector<std::string> types{"input", "output", "int",    "char",    "short",
                                                "long",  "float",  "double", "unsigned"};
    const auto& token = tokens_.peek();
    bool may_be_type = token.text.size() > 2 && tokens_.peek(1).kind == TokenKind::name; // do not suggest int for "in"
    std::string meant = may_be_type ? word_meant(token.text, types) : "";
    refuse(token.at, fmt::format("illegal token in an interface: {}", describe(token)),
           meant.empty() ? "expected channels such as \"input in\", or parameters such as \"int n = 3\""
                         : fmt::format("did you mean \"{}\"?", meant));
}

std::optional<EntryType> Parser::parse_entry_type() {
    const auto& word = tokens_.peek();
    if (word.is_word("input") || word.is_word("output"))
        return direction_named(tokens_.take().text);
    if (word.kind == TokenKind::name && is_parameter_type(word.text))
        return tokens_.take().text;
    return std::nullopt;
}

InterfaceEntry Parser::parse_entry(const EntryType& type) {
    InterfaceEntry entry{type, parse_declarator("a channel or parameter"), nullptr};
    if (tokens_.peek().is("=") && std::holds_alternative<Direction>(type))
        refuse(tokens_.peek().at, "a channel has no default value");
    if (accept("="))
        entry.default_value = parse_expression();
    return entry;
}

} // namespace placedpar
