#include "occam/code/generator.hpp"

#include <algorithm>

namespace placedpar::occam {

using transputer::Operation;

bool Generator::has_timer(const Alternation& a) {
    return std::ranges::any_of(a.alternatives, [](const Alternative& each) {
        const auto* nested = std::get_if<std::unique_ptr<Alternation>>(&each.guard);
        return std::holds_alternative<Delay>(each.guard) || (nested && has_timer(**nested));
    });
}

/// Enables all guards, waits, disables them in the same order, and jumps to the branch of the first ready guard.
void Generator::alternation(const Alternation& a) {
    const bool timer = has_timer(a);
    frame_->need_below(timer ? 5 : 3);
    Nest nest{.after = emitter_.new_label()};
    reserve(a, nest);
    {
        const Kept enabled(guards_are_enabled_, true);
        op(timer ? Operation::talt : Operation::alt);
        enable(a);
        op(timer ? Operation::taltwt : Operation::altwt);
        clear_error();
        disable(a, nest);
        frame_->need_low(1);
        op(Operation::altend);
    }
    mark(nest.after);
    const Label done = emitter_.new_label();
    for (const Branch& each : nest.branches) {
        branch(each);
        if (&each != &nest.branches.back())
            jump(done);
    }
    mark(done);
    clear_error();
}

/// Reserves a word for the index of each replicator. The word keeps the value that the index has for the chosen guard.
void Generator::reserve(const Alternation& a, Nest& nest) {
    if (a.replicator)
        nest.kept[a.replicator->index.get()] = temporary();
    for (const Alternative& each : a.alternatives)
        if (const auto* nested = std::get_if<std::unique_ptr<Alternation>>(&each.guard))
            reserve(**nested, nest);
}

void Generator::enable(const Alternation& a) {
    const auto all = [&] {
        for (const Alternative& each : a.alternatives)
            enable(each);
    };
    if (a.replicator)
        replicated(*a.replicator, all);
    else
        all();
}

void Generator::enable(const Alternative& a) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    const Placed placed(emitter_, a.at);
    for (const DeclarationBox& each : a.declarations)
        declare(*each);
    stack_ = 0;
    if (const auto* nested = std::get_if<std::unique_ptr<Alternation>>(&a.guard))
        return enable(**nested);
    load_guard(a);
    frame_->need_low(1);
    op(std::holds_alternative<Delay>(a.guard) ? Operation::enbt : guard_channel(a) ? Operation::enbc : Operation::enbs);
    stack_ = 0;
}

/// Returns the channel of a guard. Returns null for SKIP, for `clock ? AFTER t`, and for an input from a timer, which
/// is always ready.
const Expression* Generator::guard_channel(const Alternative& a) {
    if (const auto* variants = std::get_if<VariantInput>(&a.guard))
        return &variants->channel;
    const auto* simple = std::get_if<Input>(&a.guard);
    return simple && simple->channel.type->kind == Type::Kind::channel ? &simple->channel : nullptr;
}

/// Loads the channel or the time of a guard, if it has one, and its condition.
void Generator::load_guard(const Alternative& a) {
    std::optional<Cell> condition;
    if (a.condition && depth_of(*a.condition) > 2) {
        expression(*a.condition);
        condition = temporary();
        store(*condition);
    }
    if (const auto* delayed = std::get_if<Delay>(&a.guard))
        expression(delayed->time);
    else if (const Expression* on = guard_channel(a))
        channel(*on);
    if (condition)
        load(*condition);
    else if (a.condition)
        expression(*a.condition);
    else
        constant(1);
    settle();
}

void Generator::disable(const Alternation& a, Nest& nest) {
    const auto all = [&] {
        for (const Alternative& each : a.alternatives)
            disable(each, nest);
    };
    if (!a.replicator)
        return all();
    const Declaration* index = a.replicator->index.get();
    nest.chosen.emplace_back(index, nest.kept.at(index));
    replicated(*a.replicator, all);
    nest.chosen.pop_back();
}

void Generator::disable(const Alternative& a, Nest& nest) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    const Placed placed(emitter_, a.at);
    for (const DeclarationBox& each : a.declarations)
        declare(*each);
    stack_ = 0;
    if (const auto* nested = std::get_if<std::unique_ptr<Alternation>>(&a.guard)) {
        nest.around.push_back(&a);
        disable(**nested, nest);
        return nest.around.pop_back();
    }
    nest.branches.push_back({&a, emitter_.new_label(), nest.chosen, nest.around});
    load_guard(a);
    frame_->need_low(1); // word 0 holds the chosen branch until altend, so that no variable of the ALT may be there
    emitter_.difference(nest.branches.back().label, nest.after);
    op(std::holds_alternative<Delay>(a.guard) ? Operation::dist : guard_channel(a) ? Operation::disc : Operation::diss);
    stack_ = 1;
    if (!nest.chosen.empty()) {
        const Label other = emitter_.new_label();
        jump_if_false(other);
        for (const auto& [index, kept] : nest.chosen) {
            load(bindings_.at(index).cell);
            store(kept);
        }
        mark(other);
    }
    stack_ = 0;
}

void Generator::branch(const Branch& b) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    const Alternative& a = *b.alternative;
    mark(b.label);
    const Placed placed(emitter_, a.at);
    stack_ = 0;
    for (const auto& [index, kept] : b.indices)
        bindings_[index] = {.cell = kept, .type = index->type};
    for (const Alternative* outer : b.around)
        for (const DeclarationBox& each : outer->declarations)
            declare(*each);
    for (const DeclarationBox& each : a.declarations)
        declare(*each);
    if (const auto* simple = std::get_if<Input>(&a.guard))
        input(*simple);
    else if (const auto* variants = std::get_if<VariantInput>(&a.guard))
        variant_input(*variants);
    if (a.process)
        process(*a.process);
}

} // namespace placedpar::occam
