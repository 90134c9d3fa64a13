#include "workbench/study/condition.hpp"

#include "netlist/elaborate/evaluator.hpp"
#include "netlist/elaborate/overrides.hpp"
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

/// Without a netlist: its names mean nothing here.
std::optional<Constant> constant_of_setting(const std::string& text, const Scopes& scopes) {
    Reporter reporter;
    ExpressionPointer expression = parsed_expression(std::make_shared<const SourceFile>("", text), reporter);
    std::optional<Constant> constant;
    if (expression)
        attempt([&] { constant = Evaluator(scopes, reporter).evaluate(*expression); });
    return constant;
}

const Scopes& no_names() {
    static const Scopes scopes{Catalogue()};
    return scopes;
}

/// "master.trials" is also "trials", unless something else is called so.
Overrides named_plainly(const Overrides& set) {
    Overrides named = set;
    for (const auto& [name, text] : set)
        named.emplace(name.substr(name.rfind('.') + 1), text);
    return named;
}

[[noreturn]] void refuse_condition(Reporter& reporter) { throw RefusedInput(render(reporter.take())); }

} // namespace

std::optional<double> number_of_setting(const std::string& text) {
    std::optional<Constant> constant = constant_of_setting(text, no_names());
    if (!constant || !constant->is_number())
        return std::nullopt;
    return constant->integer() ? static_cast<double>(constant->integer()->decimal) : *constant->real();
}

struct StudyCondition::Parsed {
    ExpressionPointer expression;
    Scopes scopes{Catalogue()};

    void declare(const Overrides& set) {
        for (const auto& [name, text] : named_plainly(set))
            scopes.declare(name, {constant_of_setting(text, no_names()).value_or(Constant{text}), {}});
    }
};

StudyCondition::StudyCondition(const std::string& text) {
    if (text.empty())
        return;
    Reporter reporter;
    ExpressionPointer expression = parsed_expression(std::make_shared<const SourceFile>("where", text), reporter);
    if (!expression)
        refuse_condition(reporter);
    parsed_ = std::make_unique<Parsed>();
    parsed_->expression = std::move(expression);
}

StudyCondition::~StudyCondition() = default;
StudyCondition::StudyCondition(StudyCondition&&) noexcept = default;
StudyCondition& StudyCondition::operator=(StudyCondition&&) noexcept = default;

bool StudyCondition::holds(const Overrides& set) const {
    if (!parsed_)
        return true;
    Reporter reporter;
    bool holds = false;
    parsed_->scopes.open();
    parsed_->declare(set);
    attempt([&] { holds = Evaluator(parsed_->scopes, reporter).condition(*parsed_->expression); });
    parsed_->scopes.close();
    if (reporter.failed())
        refuse_condition(reporter);
    return holds;
}

} // namespace placedpar
