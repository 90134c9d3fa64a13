#include "netlist/language/parser.hpp"

#include <fmt/format.h>

namespace placedpar {

std::vector<ExpressionPointer> Parser::parse_subscripts() {
    std::vector<ExpressionPointer> subscripts;
    while (accept("[")) {
        Nesting nesting(*this);
        if (tokens_.peek().is("]"))
            refuse(tokens_.peek().at, "a number is missing between \"[\" and \"]\"");
        subscripts.push_back(parse_expression());
        expect("]", "after the subscript");
    }
    return subscripts;
}

Reference Parser::parse_reference(std::string_view what, std::string_view part) {
    auto name = expect_name(what);
    Reference reference{name.at, name.text, parse_subscripts(), "", {}, {}};
    if (accept(".")) {
        const auto& word = tokens_.peek(); // after a dot, reserved words are ordinary names
        auto field = word.kind == TokenKind::name ? tokens_.take() : expect_name(part);
        reference.field = field.text;
        reference.field_at = field.at;
        reference.field_subscripts = parse_subscripts();
    }
    return reference;
}

Reference Parser::parse_target() {
    auto target = parse_reference("a val, an attribute or a parameter", "an attribute or a parameter");
    expect("=", "after the name to be set");
    return target;
}

Statement Parser::parse_connect() {
    auto at = tokens_.take().at;
    auto a = parse_reference("a link, channel or edge");
    if (!accept(",")) {
        if (!tokens_.peek().is_word("to"))
            refuse(gap(), fmt::format("\",\" or \"to\" is missing in connect: found {}", describe(tokens_.peek())),
                   "connect a.link[0] to b.link[1];");
        tokens_.take();
    }
    ConnectStatement statement{std::move(a), parse_reference("a link, channel or edge"), std::nullopt};
    if (tokens_.peek().is_word("by")) {
        tokens_.take();
        statement.by = parse_reference("a connection");
    }
    expect_semicolon("connect");
    return {at, std::move(statement)};
}

Statement Parser::parse_use() {
    auto at = tokens_.take().at;
    UseStatement statement{parse_expression(), std::nullopt};
    if (tokens_.peek().is("."))
        refuse(statement.program->at, "the name of a program must be a string",
               "write it in quotes: use \"NAME\" for process;");
    expect_word("for", "in use");
    if (tokens_.peek().is_word("process") || tokens_.peek().is_word("PROCESS"))
        tokens_.take();
    else
        statement.process = parse_reference("a process");
    expect_semicolon("use");
    return {at, std::move(statement)};
}

Statement Parser::parse_place() {
    auto at = tokens_.take().at;
    auto what = parse_reference("what is placed");
    if (!tokens_.peek().is_word("on"))
        refuse(gap(), fmt::format("\"on\" is missing in place: found {}", describe(tokens_.peek())),
               "place name on processor;");
    tokens_.take();
    PlaceStatement statement{std::move(what), parse_reference("the place")};
    expect_semicolon("place");
    return {at, std::move(statement)};
}

FaultStatement Parser::parse_fault_itself() {
    FaultStatement statement{parse_reference("a link, a connection or a device", "a link"), "", {}, {}};
    auto fault = expect_name("a fault");
    statement.fault = fault.text;
    statement.fault_at = fault.at;
    statement.attributes = parse_attributes();
    return statement;
}

Statement Parser::parse_fault() {
    auto at = tokens_.take().at;
    auto statement = parse_fault_itself();
    expect_semicolon("fault");
    return {at, std::move(statement)};
}

Statement Parser::parse_fault_option() {
    auto at = tokens_.peek().at;
    auto statement = parse_fault_itself();
    if (tokens_.peek().kind != TokenKind::end)
        refuse(tokens_.peek().at, fmt::format("illegal token after a fault: {}", describe(tokens_.peek())),
               "--fault 't[0].link[1] silent (from = 20ms)'");
    return {at, std::move(statement)};
}

Statement Parser::parse_rep() {
    auto at = tokens_.take().at;
    auto parenthesis = accept("(");
    auto name = expect_name("the replicator");
    expect("=", "after the replicator's name");
    RepStatement statement{name.text, name.at, parse_expression(), nullptr, nullptr, nullptr};
    bool to = tokens_.peek().is_word("to");
    if (!to && !tokens_.peek().is_word("for"))
        refuse(tokens_.peek().at,
               fmt::format("\"for\" or \"to\" is missing in rep: found {}", describe(tokens_.peek())),
               fmt::format("write rep {0} = first for count, or rep {0} = first to last", name.text));
    tokens_.take();
    (to ? statement.last : statement.count) = parse_expression();
    if (parenthesis)
        expect(")", "after the replicator");
    statement.body = parse_body("rep");
    return {at, std::move(statement)};
}

Statement Parser::parse_if() {
    auto at = tokens_.take().at;
    IfStatement statement{parse_expression(), nullptr, nullptr};
    if (tokens_.peek().is("="))
        refuse(tokens_.peek().at, "illegal token in a condition: \"=\"", "write == to compare");
    statement.then = parse_body("if");
    if (tokens_.peek().is_word("else")) {
        tokens_.take();
        statement.otherwise = parse_body("else");
    }
    return {at, std::move(statement)};
}

} // namespace placedpar
