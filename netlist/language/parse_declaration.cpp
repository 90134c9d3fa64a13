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
               fmt::format("the value follows the name: val {} ...;", name.text));
    auto value = parse_expression();
    expect_semicolon("val");
    return {name.at, ValStatement{name.text, std::move(value)}};
}

Statement Parser::parse_define() {
    auto at = tokens_.take().at;
    auto base = expect_name("a node type");
    auto attributes = parse_attributes();
    auto names = parse_declarators("a node type");
    for (const auto& name : names)
        if (types_.insert(name.name); !name.dimensions.empty())
            refuse(name.at, "a node type cannot be an array", "declare an array of nodes of this type instead");
    expect_semicolon("define");
    return {at, DefineStatement{base.text, base.at, std::move(attributes), std::move(names)}};
}

Statement Parser::parse_node_declaration() {
    auto type = expect_name("a node type");
    auto attributes = parse_attributes();
    auto names = parse_declarators("a node");
    expect_semicolon("declaration");
    return {type.at, NodeDeclaration{type.text, type.at, std::move(attributes), std::move(names)}};
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

Statement Parser::parse_process() {
    auto at = tokens_.take().at;
    ProcessDeclaration declaration;
    declaration.attributes = parse_process_attributes();
    if (!tokens_.peek().is(";"))
        declaration.names = parse_declarators("a process");
    expect_semicolon("process");
    return {at, std::move(declaration)};
}

/// `name[i] (n = 4);`
Statement Parser::parse_setting() {
    auto process = parse_reference("a statement");
    if (!tokens_.peek().is("("))
        refuse(process.at, fmt::format("\"{}\" begins no statement", process.name),
               tokens_.peek().kind == TokenKind::end
                   ? "a statement ends with \";\""
                   : "a declaration is TYPE name; parameters are set by name (parameter = value);");
    auto at = process.at;
    auto values = parse_attributes();
    expect_semicolon("parameter");
    return {at, ParameterSetting{std::move(process), std::move(values)}};
}

} // namespace placedpar
