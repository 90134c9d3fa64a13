#include "occam/check/checker.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace placedpar::occam {

std::vector<Formal> Checker::formals_of(const Declaration& routine) const {
    std::vector<Formal> formals;
    if (const auto* predefined = std::get_if<Predefined>(&routine.form)) {
        for (std::size_t i = 0; i < predefined->parameters.size(); ++i)
            formals.push_back({predefined->parameters[i], predefined->passing[i]});
        return formals;
    }
    const auto* procedure = std::get_if<Procedure>(&routine.form);
    const DeclarationList& list = procedure ? procedure->parameters : std::get<Function>(routine.form).parameters;
    for (const DeclarationBox& each : list)
        formals.push_back({each->type, std::get<Parameter>(each->form).passing, each->name, each.get()});
    return formals;
}

std::vector<const Type*> Checker::results_of(const Declaration& routine) const {
    if (const auto* function = std::get_if<Function>(&routine.form))
        return function->result_types;
    return std::get<Predefined>(routine.form).results;
}

void Checker::argument(Expression& expression, const Formal& formal, const std::string& of) {
    const std::string role =
        formal.name.empty() ? "this parameter of " + of : "the parameter \"" + formal.name + "\" of " + of;
    if (is_data(*formal.type) && formal.passing == Parameter::Passing::value)
        return value_of(expression, formal.type, role);
    if (is_data(*formal.type)) {
        variable(expression, "passed by reference as " + role);
        agrees(expression, formal.type, role);
        return;
    }
    check(expression);
    if (!agrees(expression, formal.type, role))
        return;
    if (expression.written_output)
        use_channel(expression, *expression.written_output ? Direction::output : Direction::input);
    if (formal.declaration && formal.declaration->direction != Direction::unused)
        use_channel(expression, formal.declaration->direction);
}

void Checker::arguments(const Place& place, const std::string& name, std::vector<Expression>& given,
                        const std::vector<Formal>& formals) {
    const bool are_all = given.size() == formals.size();
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (are_all && formals[i].type && innermost(*formals[i].type).kind != Type::Kind::mistaken)
            argument(given[i], formals[i], name);
        else
            check(given[i]);
    }
    if (are_all)
        return;
    std::string hint;
    for (const Formal& formal : formals) {
        const std::string word = formal.passing == Parameter::Passing::value ? "VAL " : "";
        hint +=
            (hint.empty() ? "" : ", ") + word + name_of(*formal.type) + (formal.name.empty() ? "" : " " + formal.name);
    }
    report(place,
           "wrong number of arguments for " + name + ": expected " + std::to_string(formals.size()) + ", found " +
               std::to_string(given.size()),
           "its parameters: (" + hint + ")", names_.find(name));
}

void Checker::effects_of_call(const Declaration& called, const Place& place) {
    const auto found = effects_.find(&called);
    if (found == effects_.end())
        return;
    const Routine effects = found->second;
    if (!effects.communicates.empty())
        communicates(place, effects.communicates + " in \"" + called.name + "\"");
    for (const Declaration* const variable : effects.assigned)
        assigned(variable, place, " through \"" + called.name + "\"");
    if (!effects.has_priority_par)
        return;
    if (inside_priority_par_)
        report(place, "\"" + called.name + "\" has a PRI PAR, and is called within another PRI PAR",
               "there are only two priorities", &called);
    if (!routines_.empty())
        routines_.back().has_priority_par = true;
}

void Checker::form_of(Process& process, Instance& instance) {
    Declaration* const found = find(instance.name, process.at);
    instance.meaning = found;
    const auto* predefined = found ? std::get_if<Predefined>(&found->form) : nullptr;
    const bool is_procedure =
        found && (std::holds_alternative<Procedure>(found->form) || (predefined && predefined->results.empty()));
    if (found && !is_procedure && is_first(found, "procedure")) {
        const bool is_function = predefined || std::holds_alternative<Function>(found->form);
        report(process.at, "\"" + instance.name + "\" is not a procedure",
               is_function ? "assign its result: x := " + instance.name + " (...)" : "", found);
    }
    if (!is_procedure) {
        for (Expression& each : instance.arguments)
            check(each);
        return;
    }
    arguments(process.at, instance.name, instance.arguments, formals_of(*found));
    effects_of_call(*found, process.at);
}

} // namespace placedpar::occam
