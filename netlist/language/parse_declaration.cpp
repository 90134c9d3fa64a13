#include "netlist/language/parser.hpp"

#include <fmt/format.h>

namespace placedpar {

Declarator Parser::parse_declarator(std::string_view what) {
    auto name = expect_name(what);
    return {name.text, name.at, parse_subscripts()};
}

std::vector<Declarator> Parser::parse_declarators(std::string_view what) {
    std::vector<Declarator> names;
    do
        names.push_back(parse_declarator(what));
    while (accept(","));
    return names;
}

Statement Parser::parse_val() {
    tokens_.take();
    auto name = expect_name("a val");
    if (tokens_.peek().is("="))
        refuse(tokens_.peek().at, "illegal token in a val statement: \"=\"",
               fmt::format("write the value after the name: val {} ...;", name.text));
    auto value = parse_expression();
    expect_semicolon("val");
    return {name.at, ValStatement{name.text, std::move(value)}};
}

Statement Parser::parse_define() {
    auto at = tokens_.take().at;
    auto base = expect_type("a node type");
    auto attributes = parse_declaration_attributes();
    std::vector<Declarator> names;
    do {
        names.push_back(parse_type_name());
        types_.insert(names.back().name);
    } while (accept(","));
    expect_semicolon("define");
    return {at, DefineStatement{base.text, base.at, std::move(attributes), std::move(names)}};
}

Token Parser::expect_type(std::string_view what) {
    return tokens_.peek().is_word("process") ? tokens_.take() : expect_name(what);
}

Declarator Parser::parse_type_name() {
    auto name = expect_type("a node type");
    if (tokens_.peek().is("["))
        refuse(name.at, "a node type cannot be an array", "declare an array of nodes of this type instead");
    return {name.text, name.at, {}};
}

Statement Parser::parse_declaration() {
    auto type = expect_type("a node type");
    bool process = type.text == "process" || type.text == "PROCESS";
    Declaration declaration{type.text, type.at, parse_declaration_attributes(), {}};
    if (!process || !tokens_.peek().is(";"))
        declaration.names = parse_declarators(process ? "a process" : "a node");
    if (tokens_.peek().is("("))
        refuse(
            tokens_.peek().at, "illegal token in a declaration: \"(\"",
            fmt::format("write attributes before the names: {} (...) {};", type.text, declaration.names.back().name));
    expect_semicolon(process ? "process" : "declaration");
    return {type.at, std::move(declaration)};
}

Statement Parser::parse_connection() {
    auto at = tokens_.take().at;
    auto attributes = parse_attributes();
    auto names = parse_declarators("a connection");
    expect_semicolon("connection");
    return {at, ConnectionDeclaration{std::move(attributes), std::move(names)}};
}

Statement Parser::parse_edge_channel() {
    auto word = tokens_.take();
    auto names = parse_declarators("an edge channel");
    expect_semicolon(word.text);
    return {word.at, EdgeChannelDeclaration{direction_named(word.text), std::move(names)}};
}

/// Parses `name[i] (n = 4);`.
Statement Parser::parse_setting() {
    auto process = parse_reference("a statement");
    if (!tokens_.peek().is("("))
        refuse(process.at, fmt::format("no statement begins with \"{}\"", process.name),
               tokens_.peek().kind == TokenKind::end
                   ? "end the statement with \";\""
                   : "a declaration has the form TYPE name; to set parameters, write name (parameter = value);");
    auto at = process.at;
    auto values = parse_attributes();
    expect_semicolon("parameter");
    return {at, ParameterSetting{std::move(process), std::move(values)}};
}

} // namespace placedpar
