#include "explore/study/expression.hpp"

#include "explore/study/setting_value.hpp"
#include "netlist/elaborate/evaluator.hpp"
#include "netlist/elaborate/option_statements.hpp"
#include "netlist/language/parser.hpp"
#include "text/user_error.hpp"

#include <utility>

namespace placedpar {

namespace {

ExpressionPointer parsed_expression(const std::shared_ptr<const SourceFile>& source, Reporter& reporter) {
    ExpressionPointer expression;
    attempt([&] {
        TokenStream tokens(source, "", reporter);
        expression = Parser(tokens, reporter).parse_whole_expression();
    });
    return reporter.failed() ? nullptr : std::move(expression);
}

/// Returns the settings, each also under the last part of its name, such as "trials" for "master.trials". If another
/// setting already has the short name, only that setting keeps it.
Overrides named_plainly(const Overrides& set) {
    Overrides named = set;
    for (const auto& [name, text] : set)
        named.emplace(name.substr(name.rfind('.') + 1), text);
    return named;
}

template <class Visit>
void visit_operands(Expression& expression, Visit visit) {
    std::visit(
        [&](auto& form) {
            if constexpr (requires { form.operand; })
                visit(*form.operand);
            if constexpr (requires { form.left; })
                visit(*form.left), visit(*form.right);
            if constexpr (requires { form.otherwise; })
                visit(*form.condition), visit(*form.then), visit(*form.otherwise);
            if constexpr (requires { form.array; })
                visit(*form.array);
            if constexpr (requires { form.subscript; })
                visit(*form.subscript);
            if constexpr (requires { form.elements; })
                for (const ExpressionPointer& each : form.elements)
                    visit(*each);
        },
        expression.form);
}

bool has_frequency(Expression& expression) {
    const auto* use = std::get_if<NameUse>(&expression.form);
    bool found = use && is_frequency(use->name);
    visit_operands(expression, [&](Expression& operand) { found |= has_frequency(operand); });
    return found;
}

void add_names(Expression& expression, std::set<std::string>& names) {
    if (const auto* use = std::get_if<NameUse>(&expression.form))
        names.insert(use->name);
    visit_operands(expression, [&](Expression& operand) { add_names(operand, names); });
}

void read_as_frequency(Expression& expression) {
    if (auto* literal = std::get_if<IntegerLiteral>(&expression.form))
        literal->value.value = literal->value.decimal;
    visit_operands(expression, read_as_frequency);
}

/// Reads numbers that are compared with a clock or the speed of a link as frequencies: 20M is 20 million.
void read_frequencies(Expression& expression) {
    const auto* operation = std::get_if<BinaryOperation>(&expression.form);
    if (operation && operation->symbol != "&&" && operation->symbol != "||" && has_frequency(expression))
        read_as_frequency(expression);
    else
        visit_operands(expression, read_frequencies);
}

Constant constant_of(const std::string& name, const std::string& text) {
    Constant constant = constant_of_setting(text).value_or(Constant{text});
    if (auto* integer = std::get_if<Integer>(&constant.value); integer && is_frequency(name))
        integer->value = integer->decimal;
    return constant;
}

[[noreturn]] void refuse_expression(Reporter& reporter) { throw RefusedInput(render(reporter.take())); }

} // namespace

struct StudyExpression::Parsed {
    ExpressionPointer expression;
    Scopes scopes{Catalogue()};

    void declare(const Overrides& set, const Figures& figures) {
        for (const auto& [name, value] : figures)
            scopes.declare(name, {Constant{value}, {}});
        for (const auto& [name, text] : named_plainly(set))
            scopes.declare(name, {constant_of(name, text), {}});
    }
};

StudyExpression::StudyExpression(const std::string& text) {
    if (text.empty())
        return;
    Reporter reporter;
    ExpressionPointer expression = parsed_expression(std::make_shared<const SourceFile>("where", text), reporter);
    if (!expression)
        refuse_expression(reporter);
    parsed_ = std::make_shared<Parsed>();
    parsed_->expression = std::move(expression);
    read_frequencies(*parsed_->expression);
}

std::set<std::string> StudyExpression::names() const {
    std::set<std::string> names;
    if (parsed_)
        add_names(*parsed_->expression, names);
    return names;
}

template <class Read>
void StudyExpression::evaluate(const Overrides& set, const Figures& figures, Read read) const {
    Reporter reporter;
    parsed_->scopes.open();
    parsed_->declare(set, figures);
    attempt([&] { read(Evaluator(parsed_->scopes, reporter)); });
    parsed_->scopes.close();
    if (reporter.failed())
        refuse_expression(reporter);
}

bool StudyExpression::holds(const Overrides& set) const {
    bool holds = true;
    if (parsed_)
        evaluate(set, {}, [&](Evaluator evaluator) { holds = evaluator.condition(*parsed_->expression); });
    return holds;
}

double StudyExpression::value(const Overrides& set, const Figures& figures) const {
    double value = 0;
    evaluate(set, figures, [&](Evaluator evaluator) { value = evaluator.number(*parsed_->expression, "a figure"); });
    return value;
}

} // namespace placedpar
