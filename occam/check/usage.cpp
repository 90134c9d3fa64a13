#include "occam/check/usage.hpp"

#include "occam/check/checker.hpp"

#include <memory>
#include <set>
#include <tuple>
#include <variant>

namespace placedpar::occam {

void UsageCheck::check_program() {
    for (const std::unique_ptr<Unit>& unit : program_.units)
        declare(unit->declarations);
    declare(program_.declarations);
}

void UsageCheck::visit(const Process& process) {
    const std::size_t active = active_.size();
    std::visit([&](const auto& form) { visit_form(process, form); }, process.form);
    active_.resize(active);
}

void UsageCheck::visit(const Process* process) {
    if (process)
        visit(*process);
}

void UsageCheck::visit_form(const Process&, const Assignment& assignment) {
    for (const Expression& value : assignment.values)
        read(value);
    std::vector<Part> parts;
    for (const Expression& target : assignment.targets)
        parts.push_back(changed_part(target));
    if (usage_)
        check_parts(parts, false, "in one assignment");
    if (aliases_ && assignment.targets.size() == 1)
        check_block(assignment.targets[0], assignment.values[0]);
}

void UsageCheck::input_items(const std::vector<Item>& items) {
    for (const Item& item : items) {
        use(item.value, AccessKind::write);
        if (item.counted_array)
            use(*item.counted_array, AccessKind::write);
    }
}

void UsageCheck::visit_input(const Input& input) {
    use(input.channel, AccessKind::input);
    input_items(input.items);
}

void UsageCheck::visit_form(const Process&, const Input& input) { visit_input(input); }

void UsageCheck::visit_form(const Process&, const Delay& delay) { read(delay.time); }

void UsageCheck::visit_variants(const VariantInput& input) {
    use(input.channel, AccessKind::input);
    for (const Variant& variant : input.variants) {
        const std::size_t active = active_.size();
        declare(variant.declarations);
        input_items(variant.items);
        visit(variant.process.get());
        active_.resize(active);
    }
}

void UsageCheck::visit_form(const Process&, const VariantInput& input) { visit_variants(input); }

void UsageCheck::visit_form(const Process&, const Output& output) {
    use(output.channel, AccessKind::output);
    for (std::size_t i = output.tag_value ? 1 : 0; i < output.items.size(); ++i) {
        read(output.items[i].value);
        if (output.items[i].counted_array)
            read(*output.items[i].counted_array);
    }
}

void UsageCheck::open_replicator(const std::optional<Replicator>& replicator) {
    if (!replicator)
        return;
    read(replicator->base);
    read(replicator->count);
    if (replicator->step)
        read(*replicator->step);
    declared_[replicator->index.get()] = ++clock_;
    replicators_[replicator->index.get()] = &*replicator;
    open_indices_.insert(replicator->index.get());
}

void UsageCheck::close_replicator(const std::optional<Replicator>& replicator) {
    if (replicator)
        open_indices_.erase(replicator->index.get());
}

void UsageCheck::visit_form(const Process&, const Sequence& sequence) {
    open_replicator(sequence.replicator);
    for (const Process& each : sequence.processes)
        visit(each);
    close_replicator(sequence.replicator);
}

void UsageCheck::visit_form(const Process&, const Parallel& parallel) {
    const std::uint64_t since = clock_ + 1;
    open_replicator(parallel.replicator);
    std::vector<Stretch> components;
    for (const Process& each : parallel.processes) {
        const std::size_t first = log_.size();
        visit(each);
        components.push_back({first, log_.size()});
    }
    if (usage_)
        check_parallel(parallel, components, since);
    close_replicator(parallel.replicator);
}

void UsageCheck::visit_if(const If& conditional) {
    open_replicator(conditional.replicator);
    for (const Choice& choice : conditional.choices) {
        const std::size_t active = active_.size();
        declare(choice.declarations);
        if (choice.nested)
            visit_if(*choice.nested);
        if (choice.condition)
            read(*choice.condition);
        visit(choice.process.get());
        active_.resize(active);
    }
    close_replicator(conditional.replicator);
}

void UsageCheck::visit_form(const Process&, const If& conditional) { visit_if(conditional); }

void UsageCheck::visit_form(const Process&, const Case& selection) {
    read(selection.selector);
    for (const Option& option : selection.options) {
        const std::size_t active = active_.size();
        declare(option.declarations);
        visit(option.process.get());
        active_.resize(active);
    }
}

void UsageCheck::visit_form(const Process&, const While& loop) {
    read(loop.condition);
    visit(loop.process.get());
}

void UsageCheck::visit_alternation(const Alternation& alternation) {
    open_replicator(alternation.replicator);
    for (const Alternative& each : alternation.alternatives) {
        const std::size_t active = active_.size();
        declare(each.declarations);
        if (each.condition)
            read(*each.condition);
        if (const auto* input = std::get_if<Input>(&each.guard))
            visit_input(*input);
        else if (const auto* delay = std::get_if<Delay>(&each.guard))
            read(delay->time);
        else if (const auto* variants = std::get_if<VariantInput>(&each.guard))
            visit_variants(*variants);
        else if (const auto* nested = std::get_if<std::unique_ptr<Alternation>>(&each.guard))
            visit_alternation(**nested);
        visit(each.process.get());
        active_.resize(active);
    }
    close_replicator(alternation.replicator);
}

void UsageCheck::visit_form(const Process&, const Alternation& alternation) { visit_alternation(alternation); }

void UsageCheck::visit_form(const Process& process, const Instance& instance) {
    if (instance.meaning)
        call(*instance.meaning, instance.arguments, process.at);
}

void UsageCheck::visit_form(const Process&, const Scope& scope) {
    declare(scope.declarations);
    visit(scope.process.get());
}

void UsageCheck::visit_form(const Process&, const Processor& processor) { visit(processor.process.get()); }

void UsageCheck::declare(const DeclarationList& list) {
    for (const DeclarationBox& each : list)
        declare(*each);
}

void UsageCheck::declare(const Declaration& declaration) {
    if (const auto* variable = std::get_if<Variable>(&declaration.form)) {
        if (variable->initial)
            read(*variable->initial);
    } else if (const auto* abbreviation = std::get_if<Abbreviation>(&declaration.form)) {
        abbreviate(declaration, abbreviation->value, abbreviation->is_value);
    } else if (const auto* retyping = std::get_if<Retyping>(&declaration.form)) {
        abbreviate(declaration, retyping->value, retyping->is_value);
    } else if (const auto* procedure = std::get_if<Procedure>(&declaration.form)) {
        visit_routine(declaration, procedure->parameters, nullptr, procedure->body.get());
    } else if (const auto* function = std::get_if<Function>(&declaration.form)) {
        visit_routine(declaration, function->parameters, &function->body, nullptr);
    }
    declared_[&declaration] = ++clock_;
}

void UsageCheck::abbreviate(const Declaration& declaration, const Expression& value, bool is_value) {
    if (value.constant)
        return;
    const std::size_t first = log_.size();
    const bool is_retyping = std::holds_alternative<Retyping>(declaration.form);
    if (is_value) {
        read(value);
    } else {
        read_indices(value);
        const bool is_channel = !is_data(*value.type);
        const AccessKind kind = !is_channel                                  ? AccessKind::write
                                : declaration.direction == Direction::output ? AccessKind::output
                                                                             : AccessKind::input;
        if (std::optional<Access> access = access_of(value, kind); access && !is_channel) {
            access->is_abbreviation = true;
            check_active(*access);
            active_.push_back({&declaration, *access, true});
            if (is_retyping)
                log_.push_back(*access);
        } else if (access && is_retyping && declaration.direction != Direction::unused) {
            log_.push_back(*access);
        }
    }
    for (const Access& access : accesses_since(first)) {
        if (access.kind == AccessKind::read)
            active_.push_back({&declaration, access, false});
    }
}

void UsageCheck::visit_values(const ValueProcess& process) {
    declare(process.declarations);
    visit(process.process.get());
    for (const Expression& result : process.results)
        read(result);
}

void UsageCheck::visit_routine(const Declaration& routine, const DeclarationList& parameters,
                               const ValueProcess* function, const Process* body) {
    std::vector<Active> outer;
    outer.swap(active_); // accesses of a routine are compared with the abbreviations outside of it at each call
    const std::size_t first = log_.size();
    const std::uint64_t since = clock_ + 1;
    declare(parameters);
    if (function)
        visit_values(*function);
    visit(body);
    active_.swap(outer);
    summaries_[&routine] = outside_accesses(first, since);
    log_.resize(first);
}

/// Returns the accesses in the log from position `first` on whose variables were declared before the time `since`,
/// counted by clock_. Each of several equal accesses is returned once. If an access uses an abbreviation that was
/// declared later, the result has the abbreviated variable instead.
std::vector<Access> UsageCheck::outside_accesses(std::size_t first, std::uint64_t since) const {
    std::vector<Access> accesses;
    std::set<std::tuple<const Declaration*, const Declaration*, AccessKind, std::vector<const void*>>> seen;
    const auto is_outside = [&](const Declaration* each) {
        const auto declared = declared_.find(each);
        return declared == declared_.end() || declared->second < since;
    };
    for (std::size_t i = first; i < log_.size(); ++i) {
        Access access = log_[i];
        if (!is_outside(access.base))
            continue;
        while (!is_outside(access.root))
            access.root = named_by(*access.root);
        std::vector<const void*> steps;
        for (const PathStep& step : access.steps) {
            steps.push_back(step.index);
            steps.push_back(step.count);
        }
        if (seen.insert({access.base, access.root, access.kind, std::move(steps)}).second)
            accesses.push_back(std::move(access));
    }
    return accesses;
}

} // namespace placedpar::occam
