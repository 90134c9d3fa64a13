#include "netlist/elaborate/elaborator.hpp"

#include "netlist/elaborate/declared_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace placedpar {

Elaborator::Elaborator(const Catalogue& catalogue, const Statements& overrides, Reporter& reporter)
    : catalogue_(catalogue), reporter_(reporter), scopes_(catalogue), evaluator_(scopes_, reporter),
      overrides_(overrides) {
    // No node, connection or process of the network may have a predefined name, since the printed network uses these
    // names.
    claimed_.insert("HIGH");
    for (const auto& [name, type] : catalogue.node_types())
        claimed_.insert(type.preset.type);
    scopes_.declare_predefined("host", {DeclaredThings{Category::node, nowhere, {}}, {}});
}

void Elaborator::refuse(const Location& at, std::string message, std::string hint, std::vector<SecondPlace> others) {
    reporter_.error(at, std::move(message), std::move(hint), std::move(others));
    throw StatementRefused{};
}

void Elaborator::run(const Statements& statements) {
    execute_all(statements);
    check_crosspoints();
}

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
    if (!overrides_.empty())
        value = overridden(form.name, value);
    scopes_.declare(form.name, {value, at});
}

std::int64_t Elaborator::behind_last(const Expression& expression) {
    auto last = evaluator_.integer(expression, "the last value of a replicator").value;
    if (last == std::numeric_limits<std::int64_t>::max())
        refuse(expression.at, fmt::format("a replicator cannot count to {}", last));
    return last + 1;
}

std::int64_t Elaborator::behind_count(std::int64_t first, const Expression& expression) {
    auto count = evaluator_.integer(expression, "a replicator's count").value;
    std::int64_t end = 0;
    if (count < 0)
        refuse(expression.at, fmt::format("a replicator cannot count {} times", count),
               "expected a count of 0 or more");
    if (__builtin_add_overflow(first, count, &end))
        refuse(expression.at, fmt::format("{} + {} does not fit in 64 bits", first, count));
    return end;
}

void Elaborator::perform(const RepStatement& form, const Location& at) {
    auto first = evaluator_.integer(*form.first, "a replicator").value;
    auto end = form.last ? behind_last(*form.last) : behind_count(first, *form.count);
    std::size_t rounds_in_vain = 0;
    for (auto i = first; i < end; ++i) {
        if (reporter_.failed() && ++rounds_in_vain > most_repeated)
            return; // the netlist is refused; further rounds would repeat errors
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
