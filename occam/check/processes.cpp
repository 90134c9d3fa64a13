#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"

#include <utility>
#include <variant>

namespace placedpar::occam {

void Checker::check(Process& process) {
    std::visit([&](auto& form) { form_of(process, form); }, process.form);
}

void Checker::form_of(Process& process, Assignment& assignment) {
    const std::vector<const Type*> given = types_of_values(assignment.values);
    std::vector<const Type*> wanted;
    for (Expression& target : assignment.targets)
        wanted.push_back(variable(target, "assigned to"));
    if (wanted.size() != 1 || given.size() != 1) {
        has_values(process.at, "variables", assignment.values, given, wanted);
        return;
    }
    const auto* use = std::get_if<NameUse>(&assignment.targets[0].form);
    agrees(assignment.values[0], wanted[0], use ? "the value for \"" + use->name + "\"" : "the value");
}

void Checker::check_replicator(Replicator& replicator) {
    value_of(replicator.base, basic(Basic::integer), "the base of a replicator");
    value_of(replicator.count, basic(Basic::integer), "the count of a replicator");
    if (replicator.step)
        value_of(*replicator.step, basic(Basic::integer), "the step of a replicator");
    if (replicator.count.constant && replicator.count.constant->bits < 0)
        report(replicator.count.at,
               "the count of this replicator is " + std::to_string(replicator.count.constant->bits),
               "the count must be 0 or more");
    replicator.index->type = basic(Basic::integer);
    add(*replicator.index);
}

void Checker::form_of(Process&, Sequence& sequence) {
    const std::size_t mark = names_.mark();
    if (sequence.replicator)
        check_replicator(*sequence.replicator);
    for (Process& each : sequence.processes)
        check(each);
    names_.leave(mark);
}

void Checker::check_priority(const Process& process, const Parallel& parallel) {
    if (parallel.replicator)
        return report(process.at, "PRI PAR cannot be replicated", "its two processes have high and low priority");
    if (parallel.processes.size() != 2)
        report(process.at, "PRI PAR has exactly two processes, not " + std::to_string(parallel.processes.size()),
               "put several processes of one priority into a PAR");
    if (inside_priority_par_)
        report(process.at, "PRI PAR cannot be within another PRI PAR", "there are only two priorities");
    if (!routines_.empty())
        routines_.back().has_priority_par = true;
}

void Checker::form_of(Process& process, Parallel& parallel) {
    communicates(process.at, "a PAR");
    const std::size_t mark = names_.mark();
    const bool is_priority = parallel.kind == Parallel::Kind::priority;
    if (is_priority)
        check_priority(process, parallel);
    if (parallel.replicator) {
        check_replicator(*parallel.replicator);
        const Expression& count = parallel.replicator->count;
        if (!count.constant && count.type->kind != Type::Kind::mistaken)
            report(count.at, "the count of a replicated PAR must be a constant", "");
    }
    // In a program that joins the processes of a network, processes of low priority may contain a PRI PAR.
    const bool only_high = is_priority && program_.has_channel_tables;
    const bool outer = inside_priority_par_;
    for (Process& each : parallel.processes) {
        inside_priority_par_ = outer || (is_priority && !(only_high && &each == &parallel.processes.back()));
        check(each);
    }
    inside_priority_par_ = outer;
    names_.leave(mark);
}

void Checker::check_if(If& conditional) {
    const std::size_t mark = names_.mark();
    if (conditional.replicator)
        check_replicator(*conditional.replicator);
    for (Choice& choice : conditional.choices) {
        const std::size_t inner = names_.mark();
        declare(choice.declarations);
        if (choice.nested)
            check_if(*choice.nested);
        if (choice.condition)
            value_of(*choice.condition, basic(Basic::boolean), "a condition");
        if (choice.process)
            check(*choice.process);
        names_.leave(inner);
    }
    names_.leave(mark);
}

void Checker::form_of(Process&, If& conditional) { check_if(conditional); }

void Checker::check_option(Option& option, const Type* selector, std::unordered_map<std::int64_t, Place>& seen) {
    const std::size_t mark = names_.mark();
    declare(option.declarations);
    for (Expression& each : option.values) {
        constant_of_type(each, selector, "an option");
        if (!each.constant || each.type->kind == Type::Kind::mistaken)
            continue;
        const auto [earlier, is_new] = seen.emplace(each.constant->bits, each.at);
        if (!is_new)
            report(each.at, "the option " + std::to_string(each.constant->bits) + " is used twice in this CASE", "",
                   {{"first used here", program_.location(earlier->second)}});
    }
    if (option.process)
        check(*option.process);
    names_.leave(mark);
}

void Checker::form_of(Process&, Case& selection) {
    const Type* selector = value(selection.selector);
    const Type& form = plain(*selector);
    const bool is_discrete = form.kind == Type::Kind::basic && !is_real(form.basic);
    if (!is_discrete && form.kind != Type::Kind::mistaken) {
        report(selection.selector.at, "CASE selects by an integer, a BYTE or a BOOL, not by " + name_of(*selector), "");
        selector = mistaken();
    }
    std::unordered_map<std::int64_t, Place> seen;
    const Option* otherwise = nullptr;
    for (Option& option : selection.options) {
        if (option.values.empty() && otherwise)
            report(option.at, "this CASE has two ELSE options", "",
                   {{"the first ELSE is here", program_.location(otherwise->at)}});
        if (option.values.empty())
            otherwise = &option;
        check_option(option, selector, seen);
    }
}

void Checker::form_of(Process&, While& loop) {
    value_of(loop.condition, basic(Basic::boolean), "the condition of WHILE");
    if (loop.process)
        check(*loop.process);
}

void Checker::check_alternation(Alternation& alternation) {
    const std::size_t mark = names_.mark();
    if (alternation.replicator)
        check_replicator(*alternation.replicator);
    for (Alternative& each : alternation.alternatives)
        check_alternative(each);
    names_.leave(mark);
}

void Checker::check_alternative(Alternative& alternative) {
    const std::size_t mark = names_.mark();
    declare(alternative.declarations);
    if (alternative.condition)
        value_of(*alternative.condition, basic(Basic::boolean), "the condition of a guard");
    if (auto* simple = std::get_if<Input>(&alternative.guard))
        input(alternative.at, *simple, true);
    else if (auto* after = std::get_if<Delay>(&alternative.guard))
        delay(alternative.at, *after);
    else if (auto* variant = std::get_if<VariantInput>(&alternative.guard))
        variant_input(*variant);
    else if (auto* nested = std::get_if<std::unique_ptr<Alternation>>(&alternative.guard))
        check_alternation(**nested);
    else if (!alternative.condition)
        report(alternative.at, "a guard without an input needs a condition", "write TRUE & SKIP");
    if (alternative.process)
        check(*alternative.process);
    names_.leave(mark);
}

void Checker::form_of(Process& process, Alternation& alternation) {
    communicates(process.at, "an ALT");
    check_alternation(alternation);
}

void Checker::form_of(Process&, Scope& scope) {
    const std::size_t mark = names_.mark();
    declare(scope.declarations);
    if (scope.process)
        check(*scope.process);
    names_.leave(mark);
}

void Checker::form_of(Process&, Processor& processor) {
    constant_of_type(processor.number, basic(Basic::integer), "the number of a processor");
    if (processor.process)
        check(*processor.process);
}

void Checker::form_of(Process& process, Wiring&) {
    report(process.at, "CONNECT, SET and MAP are not allowed in a program",
           "they belong to the NETWORK and MAPPING of a configuration");
}

} // namespace placedpar::occam
