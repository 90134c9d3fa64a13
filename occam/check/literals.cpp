#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"

#include <algorithm>
#include <variant>

namespace placedpar::occam {

namespace {

bool keeps_literals(Operator operation) {
    return operation == Operator::add || operation == Operator::subtract || operation == Operator::multiply ||
           operation == Operator::negate;
}

/// Gives the literals of an expression a type.
void set_type(Expression& expression, const Type& type) {
    if (auto* literal = std::get_if<IntegerLiteral>(&expression.form)) {
        literal->type = plain(type).basic;
        if (type.kind == Type::Kind::derived)
            literal->type_name = type.declared->name;
    } else if (auto* unary = std::get_if<UnaryOperation>(&expression.form)) {
        set_type(*unary->operand, type);
    } else if (auto* binary = std::get_if<BinaryOperation>(&expression.form)) {
        set_type(*binary->left, type);
        set_type(*binary->right, type);
    } else if (auto* table = std::get_if<TableLiteral>(&expression.form)) {
        for (Expression& each : table->elements)
            set_type(each, type);
    }
}

} // namespace

bool is_untyped(const Expression& expression) {
    if (const auto* literal = std::get_if<IntegerLiteral>(&expression.form))
        return !literal->type && literal->type_name.empty();
    if (const auto* unary = std::get_if<UnaryOperation>(&expression.form))
        return keeps_literals(unary->operation) && is_untyped(*unary->operand);
    if (const auto* binary = std::get_if<BinaryOperation>(&expression.form))
        return keeps_literals(binary->operation) && is_untyped(*binary->left) && is_untyped(*binary->right);
    const auto* table = std::get_if<TableLiteral>(&expression.form);
    return table && !table->type && std::ranges::all_of(table->elements, is_untyped);
}

/// Gives literals without a type the type that is required at their place, as occam 2.1 does. In occam 2, such literals
/// are always INT. Returns whether this was possible.
bool Checker::adapt(Expression& expression, const Type& wanted) {
    const Type& type = innermost(wanted);
    if (plain(type).kind != Type::Kind::basic || !is_integer(plain(type).basic) || !is_untyped(expression))
        return false;
    set_type(expression, type);
    check(expression);
    return true;
}

} // namespace placedpar::occam
