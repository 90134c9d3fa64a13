#include "occam/code/generator.hpp"

#include <algorithm>

namespace placedpar::occam {

using transputer::Operation;

/// Loads the address of the word in memory that is the channel.
void Generator::channel(const Expression& e) {
    if (const auto* name = std::get_if<NameUse>(&e.form))
        return address(bindings_.at(name->meaning));
    load(locate(e));
}

int Generator::depth_of_channel(const Expression& e) const {
    return std::holds_alternative<NameUse>(e.form) ? 1 : depth_of_location(e);
}

/// Loads the address of the data, the channel and the number of bytes, and generates the instruction `in` or `out`.
/// `load_count` needs one register.
void Generator::transfer(Operation operation, const std::function<void()>& load_address, const Expression& on,
                         const std::function<void()>& load_count) {
    load_address();
    if (depth_of_channel(on) > 2) {
        const Cell saved_address = temporary(), saved = temporary();
        store(saved_address);
        channel(on);
        store(saved);
        load(saved_address);
        load(saved);
    } else {
        channel(on);
    }
    settle();
    load_count();
    op(operation);
    count(-3);
    frame_->need_below(3);
    clear_error();
}

/// Inputs or outputs a value. REQUIRES: no part of its address is on the register stack.
void Generator::transfer(Operation operation, const Storage& location, const Expression& on) {
    const auto bytes = fixed_bytes(location);
    std::optional<Cell> size;
    if (!bytes) {
        load_size(location);
        size = temporary();
        store(*size);
    }
    transfer(
        operation, [&] { address(location); }, on, [&] { bytes ? constant(*bytes) : load(*size); });
}

void Generator::input(const Input& i) {
    if (i.channel.type->kind == Type::Kind::timer) {
        check_timer(i.channel);
        op(Operation::ldtimer);
        return store_top(i.items.front().value);
    }
    if (i.channel.type->kind == Type::Kind::port)
        return copy(pointer_to(locate(i.channel)), locate(i.items.front().value));
    input_items(i.channel, i.items);
}

/// Stores the value on the register stack in a variable.
void Generator::store_top(const Expression& target) {
    if (depth_of_location(target) <= 2)
        return store(locate(target));
    const Cell saved = temporary();
    store(saved);
    const Storage pointer = pointer_to(locate(target));
    load(saved);
    store(pointer);
}

void Generator::input_items(const Expression& on, const std::vector<Item>& items) {
    for (const Item& item : items) {
        stack_ = 0;
        if (item.counted_array)
            input_counted(on, item);
        else if (const auto bytes = fixed_size(*item.value.type))
            transfer(
                Operation::in, [&] { address(locate(item.value)); }, on, [&] { constant(*bytes); });
        else
            transfer(Operation::in, pointer_to(locate(item.value)), on);
    }
}

/// Inputs a count, checks that the array is large enough, and inputs as many elements as the count says.
void Generator::input_counted(const Expression& on, const Item& item) {
    const Storage counter = in_workspace(*item.value.type);
    if (counter.is_scalar) {
        constant(0);
        store(counter.cell);
    }
    transfer(Operation::in, counter, on);
    const Storage array = pointer_to(locate(*item.counted_array));
    const std::int64_t unit = size_of(*plain(*array.type).element);
    if (is_wide(*counter.type))
        check_upper_half(counter.cell);
    load(is_wide(*counter.type) ? Storage{.cell = counter.cell, .type = basic(Basic::int32)} : counter);
    if (options_.range_checks) {
        load_extent(outer_extent(array), 1);
        op(Operation::csub0);
        fails("the count {b} was received for an array of {a-1} elements");
        settle();
    }
    const Cell number = temporary();
    store(number);
    load(number);
    const Label none = emitter_.new_label();
    jump_if_false(none);
    transfer_elements(Operation::in, array, number, unit, on);
    mark(none);
    stack_ = 0;
    if (is_wide(*counter.type))
        return wide_store({.cell = counter.cell}, pointer_to(locate(item.value)));
    load(number);
    store_top(item.value);
}

/// Generates a check of a number of elements of type INT64: its upper half must be 0.
void Generator::check_upper_half(const Cell& lower) {
    if (!options_.range_checks)
        return;
    load(lower.after(1));
    constant(1);
    op(Operation::csub0);
    fails({"the count {l} does not fit in INT", {lower}});
    settle();
    stack_ = 0;
}

void Generator::transfer_elements(Operation operation, const Storage& array, const Cell& number, std::int64_t unit,
                                  const Expression& on) {
    Cell bytes = number;
    if (unit != 1 && unit != 4) {
        load(number);
        constant(unit);
        op(Operation::prod);
        bytes = temporary();
        store(bytes);
    }
    transfer(
        operation, [&] { address(array); }, on,
        [&] {
            load(bytes);
            if (unit == 4)
                op(Operation::bcnt);
        });
}

void Generator::output(const Output& o) {
    if (o.channel.type->kind == Type::Kind::port)
        return copy(pointer_to(value_in_memory(o.items.front().value)), locate(o.channel));
    if (o.tag_value)
        output_word(
            o.channel, [&] { constant(*o.tag_value); }, 1, 1);
    for (std::size_t i = o.tag_value ? 1 : 0; i < o.items.size(); ++i) {
        stack_ = 0;
        if (o.items[i].counted_array)
            output_counted(o.channel, o.items[i]);
        else
            output_item(o.channel, o.items[i].value);
    }
}

void Generator::output_item(const Expression& on, const Expression& value) {
    const Type& type = *value.type;
    const std::int64_t size = size_of(type);
    if (is_word(type) && size != 2)
        return output_word(
            on, [&] { expression(value); }, depth_of(value), size);
    const Storage location = pointer_to(value_in_memory(value));
    if (size == 4 && !is_compound(plain(type)))
        return output_word(
            on, [&] { load_bits(location); }, 1, size);
    transfer(Operation::out, location, on);
}

/// Loads a value of four bytes and of any type as a word.
void Generator::load_bits(Storage location) {
    location.type = basic(Basic::int32);
    load(location);
}

void Generator::output_word(const Expression& on, const std::function<void()>& value, int depth, std::int64_t bytes) {
    if (depth <= 2) {
        channel(on);
        value();
    } else {
        value();
        const Cell saved = temporary();
        store(saved);
        channel(on);
        load(saved);
    }
    settle();
    op(bytes == 1 ? Operation::outbyte : Operation::outword);
    count(-2);
    frame_->need_low(1);
    frame_->need_below(3);
    clear_error();
}

void Generator::output_counted(const Expression& on, const Item& item) {
    const Storage array = pointer_to(value_in_memory(*item.counted_array));
    const std::int64_t unit = size_of(*plain(*array.type).element);
    const Type& count_type = *item.value.type;
    const Storage number = in_workspace(count_type);
    if (is_wide(count_type)) {
        wide_store(wide(item.value), number);
        check_upper_half(number.cell);
        load(number.cell);
    } else {
        expression(item.value);
    }
    if (options_.range_checks && !constant_of(item.value)) {
        load_extent(outer_extent(array), 1);
        op(Operation::csub0);
        fails("the count {b} does not fit an array of {a-1} elements");
    }
    settle();
    store(number.cell);
    if (size_of(count_type) == 2 || is_wide(count_type))
        transfer(Operation::out, number, on);
    else
        output_word(
            on, [&] { load(number.cell); }, 1, size_of(count_type));
    const Label none = emitter_.new_label();
    load(number.cell);
    jump_if_false(none);
    transfer_elements(Operation::out, array, number.cell, unit, on);
    mark(none);
}

void Generator::variant_input(const VariantInput& v) {
    const Storage tag = in_workspace(*basic(Basic::byte));
    constant(0);
    store(tag.cell);
    transfer(Operation::in, tag, v.channel);
    Targets targets;
    std::vector<Label> labels;
    const Label done = emitter_.new_label(), otherwise = emitter_.new_label();
    for (const Variant& each : v.variants) {
        labels.push_back(emitter_.new_label());
        targets.emplace_back(*each.tag_value, labels.back());
    }
    std::ranges::sort(targets);
    select(tag.cell, targets, otherwise);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        mark(labels[i]);
        variant(v.channel, v.variants[i]);
        jump(done);
    }
    mark(otherwise);
    stop_here({"tag {w} was received, which this ? CASE does not list", {tag.cell}});
    mark(done);
    clear_error();
}

/// Inputs the items after the tag, and executes the process of the variant.
void Generator::variant(const Expression& on, const Variant& v) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    const bool is_short = v.at.line == emitter_.place().line; // `c ? CASE tag; x` has the place of its first character
    const Placed placed(emitter_, is_short ? emitter_.place() : v.at);
    stack_ = 0;
    for (const DeclarationBox& each : v.declarations)
        declare(*each);
    input_items(on, v.items);
    if (v.process)
        process(*v.process);
}

/// Generates the checks of the subscripts in an array of timers. A transputer has one clock, so nothing else of a timer
/// needs code.
void Generator::check_timer(const Expression& timer) {
    const auto* subscript = std::get_if<Subscript>(&timer.form);
    if (!subscript)
        return;
    check_timer(*subscript->array);
    const Type& array = plain(*subscript->array->type);
    if (array.count && !constant_of(*subscript->index)) {
        expression(*subscript->index);
        check_index({*array.count}, *subscript->index);
        settle();
        stack_ = 0;
    }
}

void Generator::delay(const Delay& d) {
    check_timer(d.timer);
    expression(d.time);
    settle();
    op(Operation::tin);
    frame_->need_below(5);
    clear_error();
}

} // namespace placedpar::occam
