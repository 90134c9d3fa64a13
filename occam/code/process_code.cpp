#include "occam/code/generator.hpp"

#include <algorithm>
#include <limits>

namespace placedpar::occam {

using transputer::Operation;

void Generator::process(const Process& p) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    const Placed placed(emitter_, p.at);
    stack_ = 0;
    struct Visitor {
        Generator& g;
        const Process& p;
        void operator()(const Skip&) {}
        void operator()(const Stop&) { g.stop_here("STOP"); }
        void operator()(const Assignment& a) { g.assignment(a); }
        void operator()(const Input& i) { g.input(i); }
        void operator()(const Delay& d) { g.delay(d); }
        void operator()(const VariantInput& v) { g.variant_input(v); }
        void operator()(const Output& o) { g.output(o); }
        void operator()(const Sequence& s) { g.sequence(s); }
        void operator()(const Parallel& each) { g.parallel(p, each); }
        void operator()(const If& i) {
            const Label done = g.emitter_.new_label();
            if (!g.choices(i, done, true))
                g.stop_here("no condition of this IF is true");
            g.mark(done);
            g.clear_error();
        }
        void operator()(const Case& c) { g.selection(c); }
        void operator()(const While& w) { g.repetition(w); }
        void operator()(const Alternation& a) { g.alternation(a); }
        void operator()(const Instance& i) { g.instance(p, i); }
        void operator()(const Scope& s) {
            for (const DeclarationBox& each : s.declarations)
                g.declare(*each);
            g.process(*s.process);
        }
        void operator()(const Processor&) {
            g.refuse(p.at, "PROCESSOR places processes on a network, but a program for one transputer has no network");
        }
        void operator()(const Wiring&) { g.refuse(p.at, "a program for one transputer has no network"); }
    };
    std::visit(Visitor{*this, p}, p.form);
    stack_ = 0;
}

// Assignments

void Generator::assignment(const Assignment& a) {
    if (a.targets.size() == 1 && a.values.size() == 1)
        return assign(a.targets.front(), a.values.front());
    multiple_assignment(a);
}

void Generator::assign(const Expression& target, const Expression& value) {
    const auto where = [&] { return locate(target); };
    const int depth = depth_of_location(target);
    if (is_word(*target.type) || is_bits(value))
        return assign_word(value, depth, where);
    if (is_compound(plain(*value.type)))
        return assign_compound(value, depth, where);
    if (!is_real(*target.type))
        return wide_store(wide(value), pointer_to(locate(target)));
    const bool first = disturbs_reals(target);
    const Storage pointer = first ? pointer_to(locate(target)) : Storage{};
    begin_reals();
    stack_ = 0;
    real(value);
    real_store(first ? pointer : locate(target));
}

/// Returns whether the value is a REAL32 that can be copied as a word, because it needs no computation.
bool Generator::is_bits(const Expression& value) const {
    return size_of(*value.type) == 4 && is_real(*value.type) &&
           (constant_of(value) || std::holds_alternative<NameUse>(value.form) ||
            std::holds_alternative<Subscript>(value.form));
}

void Generator::assign_to(const Expression& value, const Storage& target) {
    const auto where = [&] { return target; };
    if (is_word(*target.type) || is_bits(value)) {
        assign_word(value, 1, where);
    } else if (is_compound(plain(*value.type))) {
        assign_compound(value, 1, where);
    } else if (is_real(*target.type)) {
        begin_reals();
        stack_ = 0;
        real(value);
        real_store(target);
    } else {
        wide_store(wide(value), target);
    }
}

void Generator::assign_word(const Expression& value, int depth, const std::function<Storage()>& target) {
    if (depth <= 2) {
        expression(value);
        return store(target());
    }
    const Storage pointer = pointer_to(target());
    expression(value);
    store(pointer);
}

void Generator::assign_compound(const Expression& value, int depth, const std::function<Storage()>& target) {
    const Storage source = value_in_memory(value);
    const auto size = fixed_bytes(source);
    if (source.is_static() && depth <= 2 && size) {
        address(source);
        const Storage to = target();
        if (fixed_bytes(to)) {
            address(to);
            settle();
            constant(*size);
            return op(Operation::move), count(-3);
        }
        return copy(source, to);
    }
    const Storage from = pointer_to(source);
    stack_ = 0;
    copy(from, target());
}

/// Generates a copy of a value. REQUIRES: no part of its address is on the register stack.
void Generator::copy(const Storage& source, Storage target) {
    target = pointer_to(target);
    stack_ = 0;
    if (!fixed_bytes(source) || !fixed_bytes(target))
        check_sizes(source, target);
    address(source);
    address(target);
    if (fixed_bytes(source) || fixed_bytes(target)) {
        settle();
        constant(fixed_bytes(source) ? *fixed_bytes(source) : *fixed_bytes(target));
    } else {
        stack_ = 0;
        load_size(source);
        const Cell size = temporary();
        store(size);
        address(source);
        address(target);
        settle();
        load(size);
    }
    op(Operation::move);
    count(-3);
}

/// Generates a check that both arrays of an assignment have the same size.
void Generator::check_sizes(const Storage& a, const Storage& b) {
    if (!options_.range_checks)
        return;
    load_size(a);
    const Cell size = temporary();
    store(size);
    load_size(b);
    load(size);
    op(Operation::diff);
    const Label equal = emitter_.new_label();
    jump_if_false(equal);
    stop_here("the arrays of this assignment differ in size");
    mark(equal);
    stack_ = 0;
}

void Generator::multiple_assignment(const Assignment& a) {
    std::vector<Storage> results;
    const auto* values = std::get_if<ValueProcess>(&a.values.front().form);
    const auto* called = std::get_if<Call>(&a.values.front().form);
    if (called && std::holds_alternative<Predefined>(called->meaning->form) &&
        std::ranges::all_of(a.targets, [this](const Expression& target) { return is_word_of_frame(target); })) {
        for (const Expression& target : a.targets)
            results.push_back(locate(target));
        return call_function(a.values.front(), results);
    }
    for (const Expression& target : a.targets) {
        results.push_back(temporary_location(*target.type));
        if (results.back().is_scalar &&
            called) { // clears the whole word, since a function writes only the bytes of the type
            constant(0);
            store(results.back().cell);
        }
    }
    if (a.values.size() > 1) {
        for (std::size_t i = 0; i < results.size(); ++i)
            assign_to(a.values[i], results[i]);
    } else if (!values) {
        call_function(a.values.front(), results);
    } else {
        value_process(*values, [&] {
            for (std::size_t i = 0; i < results.size(); ++i)
                assign_to(values->results[i], results[i]);
        });
    }
    for (std::size_t i = 0; i < results.size(); ++i) {
        stack_ = 0;
        store_from(results[i], a.targets[i]);
    }
}

/// Returns whether the target of an assignment is a whole word of the workspace.
bool Generator::is_word_of_frame(const Expression& target) {
    if (!is_word(*target.type) || size_of(*target.type) != 4 || depth_of_location(target) != 1)
        return false;
    const Storage location = locate(target);
    return location.base == Storage::Base::cell && location.cell.frame->level == level_;
}

/// Generates a copy of a value. REQUIRES: no part of its address is on the register stack.
void Generator::store_from(const Storage& value, const Expression& target) {
    if (is_word(*target.type) && depth_of_location(target) <= 2) {
        load(value);
        store(locate(target));
    } else if (is_word(*target.type)) {
        const Storage pointer = pointer_to(locate(target));
        load(value);
        store(pointer);
    } else {
        copy(value, locate(target));
    }
}

// Sequences, conditions and repetitions

void Generator::sequence(const Sequence& s) {
    if (s.replicator)
        return replicated(*s.replicator, [&] { process(s.processes.front()); });
    for (const Process& each : s.processes)
        process(each);
}

/// Generates the beginning of a replicator: stores the first index and the count in two words, and jumps to `end` if
/// the count is 0.
Cell Generator::begin_replication(const Replicator& r, Label end) {
    const Cell control = temporary(2);
    const auto base = constant_of(r.base), count_of = constant_of(r.count);
    if (base && count_of && !r.step)
        ranges_[r.index.get()] = {*base, *base + std::max<std::int64_t>(*count_of, 1) - 1};
    expression(r.base);
    settle();
    store(control);
    expression(r.count);
    settle();
    store(control.after(1));
    if (count_of && *count_of > 0)
        return control;
    load(control.after(1));
    if (options_.range_checks) {
        op(Operation::mint);
        op(Operation::csub0);
        fails("the count of this replicator is {b}, but must be 0 or more");
        settle();
    }
    jump_if_false(end);
    return control;
}

void Generator::replicated(const Replicator& r, const std::function<void()>& body) {
    const Label end = emitter_.new_label(), start = emitter_.new_label();
    const Cell control = begin_replication(r, end);
    Cell index = control;
    std::optional<Cell> step;
    if (r.step) {
        index = temporary();
        step = temporary();
        load(control);
        store(index);
        expression(*r.step);
        settle();
        store(*step);
    }
    bindings_[r.index.get()] = {.cell = index, .type = r.index->type};
    loop(control, start, [&] {
        body();
        if (step) {
            load(index);
            load(*step);
            op(Operation::bsub);
            store(index);
        }
    });
    mark(end);
}

bool Generator::choices(const If& i, Label done, bool is_last) {
    if (i.replicator) {
        replicated(*i.replicator, [&] { choice(i.choices.front(), done, false); });
        return false;
    }
    for (const Choice& each : i.choices)
        if (choice(each, done, is_last && &each == &i.choices.back()))
            return true;
    return false;
}

bool Generator::choice(const Choice& c, Label done, bool is_last) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    const Placed placed(emitter_, c.at);
    stack_ = 0;
    for (const DeclarationBox& each : c.declarations)
        declare(*each);
    if (c.nested)
        return choices(*c.nested, done, is_last);
    const auto value = constant_of(*c.condition);
    if (std::holds_alternative<Skip>(c.process->form) && !value) {
        expression(*c.condition);
        op(Operation::eqc, 0);
        settle();
        jump_if_false(done);
        stack_ = 0;
        return false;
    }
    const Label next = emitter_.new_label();
    condition(*c.condition, next);
    process(*c.process);
    if (!(value && is_last))
        jump(done);
    mark(next);
    stack_ = 0;
    return value && *value != 0;
}

void Generator::repetition(const While& w) {
    const Label start = emitter_.new_label(), end = emitter_.new_label();
    {
        const Kept weight(weight_, weight_ * 8);
        mark(start);
        clear_error();
        condition(w.condition, end);
        process(*w.process);
        jump(start);
    }
    mark(end);
    frame_->need_below(3);
}

// CASE

namespace {

/// Number of bytes of an entry in a table of jumps. A jump of this length reaches 32 Kbyte in either direction.
constexpr std::uint8_t bytes_of_jump = 4;

} // namespace

void Generator::selection(const Case& c) {
    const Label done = emitter_.new_label(), otherwise = emitter_.new_label();
    Targets targets;
    std::vector<Label> labels;
    for (const Option& option : c.options) {
        labels.push_back(option.values.empty() ? otherwise : emitter_.new_label());
        for (const Expression& value : option.values)
            targets.emplace_back(*constant_of(value), labels.back());
    }
    std::ranges::sort(targets);
    const ErrorText selected = go_to_target(c.selector, targets, otherwise);
    bool has_else = false;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Option& option = c.options[i];
        has_else |= option.values.empty();
        const Kept top(frame_->top);
        const Kept vector(level_->vector_now);
        mark(labels[i]);
        stack_ = 0;
        for (const DeclarationBox& each : option.declarations)
            declare(*each);
        process(*option.process);
        if (i + 1 < labels.size() || !has_else)
            jump(done);
    }
    if (!has_else) {
        mark(otherwise);
        stop_here({"this CASE has no option for " + selected.text, selected.cells});
    }
    mark(done);
    clear_error();
}

Generator::ErrorText Generator::go_to_target(const Expression& value, const Targets& targets, Label otherwise) {
    if (is_wide(*value.type))
        return select_wide(wide(value), targets, otherwise);
    const Cell selector = temporary();
    expression(value);
    settle();
    store(selector);
    const bool is_dense = targets.size() >= 12 && targets.front().first > std::numeric_limits<std::int32_t>::min() &&
                          targets.back().first - targets.front().first < 2 * static_cast<std::int64_t>(targets.size());
    if (is_dense)
        select_by_table(selector, targets, otherwise);
    else
        select(selector, targets, otherwise);
    return {"{w}", {selector}};
}

/// Generates a jump to the option of a CASE whose value equals the selector, an INT64. Compares one option after the
/// other.
Generator::ErrorText Generator::select_wide(const Wide& selector, const Targets& targets, Label otherwise) {
    for (const auto& [value, label] : targets) {
        stack_ = 0;
        for (int part = 0; part < 2; ++part) {
            load_part(selector, part);
            load_part({.constant = value}, part);
            op(Operation::diff);
        }
        op(Operation::or_);
        jump_if_false(label);
    }
    stack_ = 0;
    jump(otherwise);
    return selector.constant ? ErrorText{std::to_string(*selector.constant), {}} : ErrorText{"{l}", {selector.cell}};
}

/// Generates a jump to the option of a CASE whose value equals the selector, by a binary search.
void Generator::select(const Cell& selector, std::span<const Targets::value_type> targets, Label otherwise) {
    if (targets.size() > 3) {
        const auto half = targets.size() / 2;
        const Label upper = emitter_.new_label();
        constant(targets[half].first);
        load(selector);
        op(Operation::gt);
        jump_if_false(upper);
        select(selector, targets.first(half), otherwise);
        mark(upper);
        return select(selector, targets.subspan(half), otherwise);
    }
    for (const auto& [value, label] : targets) {
        constant(value);
        load(selector);
        op(Operation::diff);
        jump_if_false(label);
        stack_ = 0;
    }
    jump(otherwise);
}

/// Generates a jump to the option of a CASE whose value equals the selector, by a table of jumps.
void Generator::select_by_table(const Cell& selector, const Targets& targets, Label otherwise) {
    const std::int64_t least = targets.front().first, most = targets.back().first;
    for (const bool below : {true, false}) {
        const Label inside = emitter_.new_label();
        constant(below ? least : most);
        load(selector);
        if (!below)
            op(Operation::rev);
        op(Operation::gt);
        jump_if_false(inside);
        jump(otherwise);
        mark(inside);
    }
    const Label table = emitter_.new_label(), here = emitter_.new_label();
    load(selector);
    if (least != 0)
        op(Operation::adc, -least);
    constant(bytes_of_jump);
    op(Operation::prod);
    emitter_.difference(table, here);
    count(1);
    op(Operation::ldpi);
    mark(here);
    op(Operation::bsub);
    op(Operation::gcall);
    mark(table);
    auto next = targets.begin();
    for (std::int64_t value = least; value <= most; ++value)
        emitter_.branch(Operation::j, next->first == value ? (next++)->second : otherwise, bytes_of_jump);
}

} // namespace placedpar::occam
