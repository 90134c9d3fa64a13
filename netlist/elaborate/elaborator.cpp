#include "netlist/elaborate/elaborator.hpp"

#include "netlist/elaborate/declared_names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

Elaborator::Elaborator(const Catalogue& catalogue, const Overrides& overrides, Reporter& reporter)
    : catalogue_(catalogue), overrides_(overrides), reporter_(reporter), scopes_(catalogue),
      evaluator_(scopes_, reporter) {
    for (const auto& name : scopes_.names())
        claimed_.insert(name);
    scopes_.declare_predefined("host", {DeclaredThings{Category::node, nowhere, {}}, {}});
}

void Elaborator::refuse(const Location& at, std::string message, std::string hint, std::vector<SecondPlace> others) {
    reporter_.error(at, std::move(message), std::move(hint), std::move(others));
    throw StatementRefused{};
}

void Elaborator::run(const Statements& statements) { execute_all(statements); }

void Elaborator::execute_all(const Statements& statements) {
    for (std::size_t i = 0; i < statements.size(); ++i) {
        scopes_.set_ahead(std::span(statements).subspan(i + 1));
        execute(statements[i]);
    }
}

void Elaborator::execute(const Statement& statement) {
    evaluator_.step(statement.at);
    try {
        std::visit([&](const auto& form) { perform(form, statement.at); }, statement.form);
    } catch (const StatementRefused&) {
        for (const auto& declared : declared_names(statement))
            scopes_.poison(std::string(declared.name));
    }
}

void Elaborator::perform(const ValStatement& form, const Location& at) {
    check_free(form.name, at);
    auto value = evaluator_.evaluate(*form.value);
    if (scopes_.outermost()) {
        vals_seen_.push_back(form.name);
        if (auto found = overrides_.find(form.name); found != overrides_.end())
            value = overridden(form.name, value, found->second);
    }
    scopes_.declare(form.name, {value, at});
}

void Elaborator::perform(const RepStatement& form, const Location& at) {
    auto first = evaluator_.integer(*form.first, "a replicator").value;
    auto count = evaluator_.integer(*form.count, "a replicator's count").value;
    std::int64_t last = 0;
    if (count < 0)
        refuse(form.count->at, fmt::format("a replicator cannot count {} times", count), "the count is 0 or more");
    if (__builtin_add_overflow(first, count, &last))
        refuse(form.count->at, fmt::format("{} + {} is beyond 64 bits", first, count));
    std::size_t rounds_in_vain = 0;
    for (auto i = first; i < last; ++i) {
        if (reporter_.failed() && ++rounds_in_vain > most_repeated)
            return; // the netlist is refused, and what else there is to say has been said
        evaluator_.step(at);
        scopes_.open();
        scopes_.declare(form.name, {integer_constant(i), form.name_at});
        execute(*form.body);
        scopes_.close();
    }
}

void Elaborator::perform(const IfStatement& form, const Location&) {
    if (evaluator_.condition(*form.condition))
        execute(*form.then);
    else if (form.otherwise)
        execute(*form.otherwise);
}

void Elaborator::perform(const BlockStatement& form, const Location&) {
    scopes_.open();
    execute_all(form.statements);
    scopes_.close();
}

} // namespace placedpar
