#include "netlist/elaborate/evaluator.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

void refuse_undefined(Reporter& reporter, const Scopes& scopes, const std::string& name, const Location& at) {
    if (!scopes.is_poisoned(name) || !reporter.failed())
        reporter.error(at, fmt::format("the name \"{}\" is undefined", name), did_you_mean(name, scopes.names()));
    throw StatementRefused{};
}

void Evaluator::refuse(const Location& at, std::string message, std::string hint, std::vector<SecondPlace> others) {
    reporter_.error(at, std::move(message), std::move(hint), std::move(others));
    throw StatementRefused{};
}

void Evaluator::step(const Location& at) {
    if (++steps_ > most_steps) {
        reporter_.error(at,
                        fmt::format("the netlist is too large: working it out takes more than {} steps", most_steps));
        throw GiveUp{};
    }
}

Constant Evaluator::evaluate_name(const NameUse& use, const Location& at) {
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

/// && and || look at their right operand only if it matters.
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

Constant Evaluator::evaluate_array(const ArrayConstant& array, const Location& at) {
    auto elements = std::make_shared<std::vector<Constant>>();
    int depth = 0;
    for (const auto& element : array.elements) {
        elements->push_back(evaluate(*element));
        const auto &first = elements->front(), &last = elements->back();
        depth = std::max(depth, last.depth + 1);
        if (first.value.index() != last.value.index() && !(first.is_number() && last.is_number()))
            refuse(at, fmt::format("an array holds values of one type: here are {} and {}", type_name(first),
                                   type_name(last)));
    }
    if (depth > deepest_array)
        refuse(at, fmt::format("the array has too many dimensions: {} are allowed", deepest_array));
    return {ConstantArray(std::move(elements)), depth};
}

Constant Evaluator::evaluate(const Expression& expression) {
    step(expression.at);
    try {
        return std::visit(
            [&](const auto& form) -> Constant {
                using Form = std::decay_t<decltype(form)>;
                if constexpr (std::is_same_v<Form, NameUse>) {
                    return evaluate_name(form, expression.at);
                } else if constexpr (std::is_same_v<Form, UnaryOperation>) {
                    return apply_unary(form.symbol, evaluate(*form.operand));
                } else if constexpr (std::is_same_v<Form, BinaryOperation>) {
                    if (form.symbol == "&&" || form.symbol == "||")
                        return evaluate_logical(form, expression.at);
                    auto left = evaluate(*form.left);
                    return apply_binary(form.symbol, left, evaluate(*form.right));
                } else if constexpr (std::is_same_v<Form, CastOperation>) {
                    return apply_cast(form.type, evaluate(*form.operand));
                } else if constexpr (std::is_same_v<Form, SubscriptOperation>) {
                    auto array = evaluate(*form.array);
                    return apply_subscript(array, evaluate(*form.subscript));
                } else if constexpr (std::is_same_v<Form, ArrayConstant>) {
                    return evaluate_array(form, expression.at);
                } else {
                    return Constant{form.value, 0};
                }
            },
            expression.form);
    } catch (const NoResult& problem) {
        refuse(expression.at, problem.message, problem.hint);
    }
}

Integer Evaluator::integer(const Expression& expression, std::string_view whose) {
    auto value = evaluate(expression);
    if (const auto* integer = value.integer())
        return *integer;
    refuse(expression.at, fmt::format("wrong type for {}: {} is {}", whose, shown(value), type_name(value)),
           "it takes an integer");
}

double Evaluator::real(const Expression& expression, std::string_view whose) {
    auto value = evaluate(expression);
    if (const auto* integer = value.integer())
        return static_cast<double>(integer->value);
    if (const auto* real = value.real())
        return *real;
    refuse(expression.at, fmt::format("wrong type for {}: {} is {}", whose, shown(value), type_name(value)),
           "it takes a number");
}

std::string Evaluator::text(const Expression& expression, std::string_view whose) {
    auto value = evaluate(expression);
    if (const auto* text = value.text())
        return *text;
    refuse(expression.at, fmt::format("wrong type for {}: {} is {}", whose, shown(value), type_name(value)),
           "it takes a string: \"...\"");
}

bool Evaluator::condition(const Expression& expression) { return integer(expression, "a condition").value != 0; }

} // namespace placedpar
