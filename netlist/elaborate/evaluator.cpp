#include "netlist/elaborate/evaluator.hpp"

#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

void report_undeclared(Reporter& reporter, const std::string& name, const Location& at, const Location& declared) {
    auto where = declared.file == at.file ? fmt::format("line {}", declared.line) : declared.text();
    reporter.error(at, fmt::format("the name \"{}\" is undefined here: it is declared later, at {}", name, where), "",
                   {{"declared here", declared}});
}

void report_unknown(Reporter& reporter, const std::string& name, const Location& at,
                    const std::vector<std::string>& known) {
    reporter.error(at, fmt::format("the name \"{}\" is undefined", name), did_you_mean(name, known));
}

} // namespace

void refuse_undefined(Reporter& reporter, const Scopes& scopes, const std::string& name, const Location& at,
                      const std::function<std::vector<std::string>()>& known) {
    if (auto declared = reporter.keeps_more() ? scopes.declared_later(name) : std::nullopt)
        report_undeclared(reporter, name, at, *declared);
    else if (!scopes.is_poisoned(name) || !reporter.failed())
        report_unknown(reporter, name, at, known ? known() : scopes.names());
    throw StatementRefused{};
}

void Evaluator::refuse(const Location& at, std::string message, std::string hint, std::vector<SecondPlace> others) {
    reporter_.error(at, std::move(message), std::move(hint), std::move(others));
    throw StatementRefused{};
}

void Evaluator::step(const Location& at) {
    if (++steps_ > most_steps)
        reporter_.give_up(
            at, fmt::format("the netlist is too large: its elaboration takes more than {} steps", most_steps));
}

Constant Evaluator::value_of(const NameUse& use, const Location& at) {
    const auto* symbol = scopes_.find(use.name);
    if (symbol == nullptr)
        refuse_undefined(reporter_, scopes_, use.name, at);
    if (const auto* constant = std::get_if<Constant>(&symbol->meaning))
        return *constant;
    std::vector<SecondPlace> others;
    if (symbol->declared.file)
        others.push_back({"declared here", symbol->declared});
    refuse(at, fmt::format("\"{}\" is {}, which has no value", use.name, describe(*symbol)), "", std::move(others));
}

/// Evaluates && and ||. The right operand is evaluated only if the left operand does not decide the result.
Constant Evaluator::evaluate_logical(const BinaryOperation& operation, const Location& at) {
    auto truth = [&](const Expression& side) {
        auto value = evaluate(side);
        if (value.integer() == nullptr)
            refuse(at, fmt::format("wrong type for the operator {}: the operand is {}", operation.symbol,
                                   type_name(value)));
        return value.integer()->value != 0;
    };
    bool left = truth(*operation.left);
    if (operation.symbol == "&&")
        return integer_constant(left && truth(*operation.right) ? 1 : 0);
    return integer_constant(left || truth(*operation.right) ? 1 : 0);
}

Constant Evaluator::value_of(const ArrayConstant& array, const Location& at) {
    auto elements = std::make_shared<std::vector<Constant>>();
    int depth = 0;
    for (const auto& element : array.elements) {
        elements->push_back(evaluate(*element));
        const auto &first = elements->front(), &last = elements->back();
        depth = std::max(depth, last.depth + 1);
        check_shape(first, last, at, element->at);
    }
    if (depth > deepest_array)
        refuse(at, fmt::format("the array has too many dimensions: at most {} are allowed", deepest_array));
    return {ConstantArray(std::move(elements)), depth};
}

void Evaluator::check_shape(const Constant& first, const Constant& element, const Location& array, const Location& at) {
    if (have_same_shape(first, element))
        return;
    if (first.array() == nullptr || element.array() == nullptr)
        refuse(array, fmt::format("an array holds values of one type, but this array has {} and {}", type_name(first),
                                  type_name(element)));
    auto size = [](const Constant& row) { return (*row.array())->size(); };
    if (size(first) != size(element))
        refuse(at, fmt::format("the array is ragged: this row has {}", counted(size(element), "element")),
               fmt::format("the first row has {}", counted(size(first), "element")));
    refuse(at, "the array is ragged: the elements of this row differ in size or type from the elements of the "
               "first row");
}

Constant Evaluator::evaluate(const Expression& expression) try {
    step(expression.at);
    return std::visit([&](const auto& form) { return value_of(form, expression.at); }, expression.form);
} catch (const NoResult& problem) {
    refuse(expression.at, problem.message, problem.hint);
}

Constant Evaluator::value_of(const BinaryOperation& operation, const Location& at) {
    if (operation.symbol == "&&" || operation.symbol == "||")
        return evaluate_logical(operation, at);
    auto left = evaluate(*operation.left);
    return apply_binary(operation.symbol, left, evaluate(*operation.right));
}

Constant Evaluator::value_of(const UnaryOperation& operation, const Location&) {
    return apply_unary(operation.symbol, evaluate(*operation.operand));
}

Constant Evaluator::value_of(const ConditionalOperation& operation, const Location&) {
    return evaluate(condition(*operation.condition) ? *operation.then : *operation.otherwise);
}

Constant Evaluator::value_of(const SizeOperation& operation, const Location&) {
    return apply_size(evaluate(*operation.array));
}

Constant Evaluator::value_of(const CastOperation& operation, const Location&) {
    return apply_cast(operation.type, evaluate(*operation.operand));
}

Constant Evaluator::value_of(const SubscriptOperation& operation, const Location&) {
    auto array = evaluate(*operation.array);
    return apply_subscript(array, evaluate(*operation.subscript));
}

Integer Evaluator::integer(const Expression& expression, std::string_view whose) {
    auto value = evaluate(expression);
    if (const auto* integer = value.integer())
        return *integer;
    wrong_type(expression, value, whose, "expected an integer");
}

double Evaluator::number(const Expression& expression, std::string_view whose) {
    auto value = evaluate(expression);
    if (value.is_number())
        return as_real(value);
    wrong_type(expression, value, whose, "expected a number");
}

std::string Evaluator::text(const Expression& expression, std::string_view whose) {
    auto value = evaluate(expression);
    if (const auto* text = value.text())
        return *text;
    wrong_type(expression, value, whose, "expected a string: \"...\"");
}

void Evaluator::wrong_type(const Expression& expression, const Constant& value, std::string_view whose,
                           std::string hint) {
    refuse(expression.at, fmt::format("wrong type for {}: {} is {}", whose, shown(value), type_name(value)),
           std::move(hint));
}

bool Evaluator::condition(const Expression& expression) { return integer(expression, "a condition").value != 0; }

} // namespace placedpar
