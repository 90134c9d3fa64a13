#include "netlist/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar {

namespace {

/// Returns the precedence of a binary operator, in C's order; 0 for any other token.
int strength(const Token& token) {
    static constexpr std::array<std::string_view, 10> weakest_first{
        " || ", " && ", " | ", " ^ ", " & ", " == != ", " < > <= >= ", " << >> ", " + - ", " * / % "};
    auto is_in = [symbol = " " + token.text + " "](auto level) { return level.find(symbol) != level.npos; };
    if (token.kind != TokenKind::symbol)
        return 0;
    auto found = std::ranges::find_if(weakest_first, is_in);
    return found == weakest_first.end() ? 0 : static_cast<int>(found - weakest_first.begin()) + 1;
}

bool is_cast_type(const Token& token) {
    static constexpr std::array types{"char", "short", "int", "long", "float", "double"};
    return token.kind == TokenKind::name && std::find(types.begin(), types.end(), token.text) != types.end();
}

template <typename Form>
ExpressionPointer make(const Location& at, Form form, int height = 1) {
    return std::make_unique<Expression>(Expression{at, std::move(form), height});
}

} // namespace

int Parser::height_above(const Location& at, std::initializer_list<const Expression*> parts) {
    int height = 0;
    for (const auto* part : parts)
        height = std::max(height, part->height + 1);
    if (height > highest_expression)
        refuse(at, fmt::format("the expression is too long: at most {} operators in a row are allowed",
                               highest_expression - 1));
    return height;
}

/// Builds a binary operation or a subscript.
ExpressionPointer Parser::combine(const Token& symbol, ExpressionPointer left, ExpressionPointer right) {
    auto height = height_above(symbol.at, {left.get(), right.get()});
    if (symbol.text == "[")
        return make(symbol.at, SubscriptOperation{std::move(left), std::move(right)}, height);
    return make(symbol.at, BinaryOperation{symbol.text, std::move(left), std::move(right)}, height);
}

ExpressionPointer Parser::parse_whole_expression() {
    auto expression = parse_expression();
    if (tokens_.peek().kind != TokenKind::end)
        refuse(tokens_.peek().at, fmt::format("illegal token after an expression: {}", describe(tokens_.peek())));
    return expression;
}

ExpressionPointer Parser::parse_expression() {
    auto expression = parse_operation(0);
    return tokens_.peek().is("?") ? parse_conditional(std::move(expression)) : std::move(expression);
}

/// Parses a conditional expression after its condition. The branches may also be conditional expressions: `a ? b : c ?
/// d : e` is `a ? b : (c ? d : e)`.
ExpressionPointer Parser::parse_conditional(ExpressionPointer condition) {
    Nesting nesting(*this);
    auto at = tokens_.take().at;
    auto then = parse_expression();
    expect(":", "in a conditional expression");
    auto otherwise = parse_expression();
    auto height = height_above(at, {condition.get(), then.get(), otherwise.get()});
    return make(at, ConditionalOperation{std::move(condition), std::move(then), std::move(otherwise)}, height);
}

ExpressionPointer Parser::parse_operation(int weakest) {
    auto left = parse_unary();
    while (true) {
        auto binds = strength(tokens_.peek());
        if (binds == 0 || binds <= weakest)
            return left;
        auto symbol = tokens_.take();
        auto right = parse_operation(binds);
        left = combine(symbol, std::move(left), std::move(right));
    }
}

ExpressionPointer Parser::parse_unary() {
    const auto& token = tokens_.peek();
    if (token.is("-") || token.is("+") || token.is("!") || token.is("~")) {
        Nesting nesting(*this);
        auto symbol = tokens_.take();
        auto operand = parse_unary();
        auto height = operand->height + 1;
        return make(symbol.at, UnaryOperation{symbol.text, std::move(operand)}, height);
    }
    if (token.is("(") && is_cast_type(tokens_.peek(1)) && tokens_.peek(2).is(")"))
        return parse_cast();
    return parse_postfix();
}

ExpressionPointer Parser::parse_cast() {
    Nesting nesting(*this);
    auto at = tokens_.take().at;
    auto type = tokens_.take().text;
    tokens_.take();
    auto operand = parse_unary();
    auto height = operand->height + 1;
    return make(at, CastOperation{type, std::move(operand)}, height);
}

/// Parses `size(...)`. Since `size` is not reserved, it is the operator only before a parenthesis.
ExpressionPointer Parser::parse_size() {
    Nesting nesting(*this);
    auto at = tokens_.take().at;
    tokens_.take();
    auto array = parse_expression();
    expect(")", "after the array");
    auto height = height_above(at, {array.get()});
    return make(at, SizeOperation{std::move(array)}, height);
}

ExpressionPointer Parser::parse_postfix() {
    auto expression = parse_primary();
    while (tokens_.peek().is("[")) {
        Nesting nesting(*this);
        auto bracket = tokens_.take();
        auto subscript = parse_expression();
        expect("]", "after the subscript");
        expression = combine(bracket, std::move(expression), std::move(subscript));
    }
    return expression;
}

ExpressionPointer Parser::parse_primary() {
    const auto& token = tokens_.peek();
    if (token.is("{"))
        return parse_array_constant();
    if (token.is("(")) {
        Nesting nesting(*this);
        tokens_.take();
        auto inner = parse_expression();
        expect(")", "after the expression");
        return inner;
    }
    if (token.is_word("size") && tokens_.peek(1).is("("))
        return parse_size();
    const auto at = tokens_.peek().at; // copied, since taking a token invalidates the reference to it
    if (token.kind == TokenKind::integer)
        return make(at, IntegerLiteral{tokens_.take().integer});
    if (token.kind == TokenKind::real)
        return make(at, RealLiteral{tokens_.take().real});
    if (token.kind == TokenKind::text)
        return make(at, TextLiteral{tokens_.take().text});
    if (token.kind != TokenKind::name || is_reserved(token.text))
        refuse(token.at, fmt::format("illegal token in an expression: {}", describe(token)));
    return make(at, NameUse{tokens_.take().text});
}

ExpressionPointer Parser::parse_array_constant() {
    Nesting nesting(*this);
    auto at = tokens_.take().at;
    ++arrays_open_;
    ArrayConstant array;
    int height = 1;
    if (tokens_.peek().is("}"))
        refuse(at, "an array constant needs at least one element");
    do {
        array.elements.push_back(parse_expression());
        height = std::max(height, array.elements.back()->height + 1);
    } while (accept(","));
    expect("}", "after the array");
    --arrays_open_;
    return make(at, std::move(array), height);
}

} // namespace placedpar
