#include "occam/code/generator.hpp"

#include <algorithm>

namespace placedpar::occam {

using transputer::Operation;

// An INT64 (Wide) is either a constant, or two words of the workspace, the lower half first.

void Generator::load_part(const Wide& value, int part) {
    if (value.constant)
        constant(static_cast<std::int32_t>(*value.constant >> 32 * part));
    else
        load(value.cell.after(part));
}

/// Returns an INT64 in the workspace: a variable itself, or a copy of a constant.
Generator::Wide Generator::wide_variable(const Wide& value) {
    if (!value.constant)
        return value;
    const Wide copied{.cell = temporary(2)};
    for (int part = 0; part < 2; ++part) {
        load_part(value, part);
        store(copied.cell.after(part));
    }
    return copied;
}

Generator::Wide Generator::wide(const Expression& e) {
    stack_ = 0;
    if (const auto bits = constant_of(e))
        return {.constant = bits};
    if (std::holds_alternative<NameUse>(e.form) || std::holds_alternative<Subscript>(e.form)) {
        const Storage location = locate(e);
        if (location.base == Storage::Base::cell && !location.has_index && location.cell.frame->level == level_)
            return {.cell = location.cell.after(static_cast<int>(location.offset / 4))};
        return wide_copy(location);
    }
    const Wide result{.cell = temporary(2)};
    if (const auto routine = real_routine(e))
        call_real_routine(e, *routine, {{.cell = result.cell, .type = e.type}});
    else if (const auto* operation = std::get_if<UnaryOperation>(&e.form))
        wide_unary(*operation, result.cell);
    else if (const auto* binary_operation = std::get_if<BinaryOperation>(&e.form))
        wide_binary(*binary_operation, result.cell);
    else if (const auto* converted = std::get_if<Conversion>(&e.form))
        wide_conversion(*converted, result.cell);
    else if (std::holds_alternative<Call>(e.form))
        call_function(e, {{.cell = result.cell, .type = e.type}});
    else if (const auto* values = std::get_if<ValueProcess>(&e.form))
        value_process(*values,
                      [&] { wide_store(wide(values->results.front()), {.cell = result.cell, .type = e.type}); });
    stack_ = 0;
    return result;
}

Generator::Wide Generator::wide_copy(Storage location) {
    location = pointer_to(location);
    const Wide result{.cell = temporary(2)};
    for (int part = 0; part < 2; ++part) {
        Storage half = location;
        half.type = basic(Basic::int32);
        half.offset += 4 * part;
        load(half);
        store(result.cell.after(part));
    }
    return result;
}

void Generator::wide_store(const Wide& value, Storage location) {
    stack_ = 0;
    location = pointer_to(location);
    location.type = basic(Basic::int32);
    for (int part = 0; part < 2; ++part) {
        load_part(value, part);
        store(location);
        location.offset += 4;
    }
}

void Generator::wide_unary(const UnaryOperation& operation, const Cell& to) {
    const Wide operand = wide(*operation.operand);
    if (operation.operation != Operator::bit_not)
        return wide_difference({.constant = 0, .is_sign = true}, operand, operation.operation == Operator::negate, to);
    for (int part = 0; part < 2; ++part) {
        load_part(operand, part);
        op(Operation::not_);
        store(to.after(part));
    }
}

void Generator::wide_sum(const Wide& a, const Wide& b, bool checked, const Cell& to) {
    wide_by_parts(a, b, Operation::lsum, checked ? Operation::ladd : Operation::lsum, to);
}

void Generator::wide_difference(const Wide& a, const Wide& b, bool checked, const Cell& to) {
    wide_by_parts(a, b, Operation::ldiff, checked ? Operation::lsub : Operation::ldiff, to);
}

/// Returns what an error of this operation on two values of type INT64 means. REQUIRES: a divisor is in the workspace.
Generator::ErrorText Generator::wide_error(const Wide& a, const std::string& operation, const Wide& b) {
    const bool divides = operation == "/" || operation == "\\";
    ErrorText error{divides ? "{/l}: " : "overflow: ", {}};
    if (divides)
        error.cells.push_back(b.cell);
    const auto add = [&](const Wide& value) {
        error.text += value.constant ? std::to_string(*value.constant) : "{l}";
        if (!value.constant)
            error.cells.push_back(value.cell);
    };
    if (!a.is_sign)
        add(a);
    error.text += a.is_sign ? "-(" : " " + operation + " ";
    add(b);
    error.text += a.is_sign ? ")" : "";
    return error;
}

/// Combines the lower words, then the upper words with the carry.
void Generator::wide_by_parts(const Wide& a, const Wide& b, Operation lower, Operation upper, const Cell& to) {
    constant(0);
    load_part(a, 0);
    load_part(b, 0);
    op(lower);
    stack_ = 1;
    store(to);
    load_part(a, 1);
    load_part(b, 1);
    op(upper);
    if (may_set_error(upper))
        fails(wide_error(a, upper == Operation::ladd ? "+" : "-", b));
    stack_ = 1;
    settle();
    store(to.after(1));
}

void Generator::wide_binary(const BinaryOperation& operation, const Cell& to) {
    const Operator kind = operation.operation;
    if (kind == Operator::shift_left || kind == Operator::shift_right)
        return wide_shift(operation, to);
    const Wide left = wide(*operation.left);
    const Wide right = wide(*operation.right);
    switch (kind) {
    case Operator::add:
    case Operator::plus: return wide_sum(left, right, kind == Operator::add, to);
    case Operator::subtract:
    case Operator::minus: return wide_difference(left, right, kind == Operator::subtract, to);
    case Operator::times: return wide_product(left, right, to);
    case Operator::multiply: return wide_routine(WideRoutine::multiply, left, right, to);
    case Operator::divide: return wide_routine(WideRoutine::divide, left, right, to);
    case Operator::remainder: return wide_routine(WideRoutine::remainder, left, right, to);
    default: break;
    }
    for (int part = 0; part < 2; ++part) {
        load_part(left, part);
        load_part(right, part);
        arithmetic(kind);
        store(to.after(part));
    }
}

void Generator::wide_product(const Wide& a, const Wide& b, const Cell& to) {
    const Cell upper = temporary();
    constant(0);
    load_part(a, 0);
    load_part(b, 0);
    op(Operation::lmul);
    stack_ = 1;
    store(to);
    store(upper);
    for (int part = 0; part < 2; ++part) {
        stack_ = 0;
        load_part(a, part);
        load_part(b, 1 - part);
        op(Operation::prod);
        load(upper);
        op(Operation::bsub);
        store(part == 0 ? upper : to.after(1));
    }
}

void Generator::wide_shift(const BinaryOperation& operation, const Cell& to) {
    const Wide value = wide(*operation.left);
    stack_ = 0;
    const Cell places = temporary();
    expression(*operation.right);
    if (options_.range_checks && !constant_of(*operation.right)) {
        constant(65);
        op(Operation::csub0);
        fails("the shift count is {b}, but must be 0 to {a-1}");
        settle();
    }
    store(places);
    load_part(value, 1);
    load_part(value, 0);
    load(places);
    op(operation.operation == Operator::shift_left ? Operation::lshl : Operation::lshr);
    stack_ = 2;
    store(to);
    store(to.after(1));
}

void Generator::wide_conversion(const Conversion& converted, const Cell& to) {
    const Type& from = *converted.operand->type;
    if (is_real(from))
        return real_to_wide(converted, to);
    if (is_wide(from))
        return wide_store(wide(*converted.operand), {.cell = to, .type = basic(Basic::int64)});
    expression(*converted.operand);
    if (plain(from).is(Basic::byte) || plain(from).is(Basic::boolean)) {
        store(to);
        constant(0);
        return store(to.after(1));
    }
    op(Operation::xdble);
    stack_ = 2;
    store(to);
    store(to.after(1));
}

/// Compares two values: the upper halves, and if these are equal, the lower halves as unsigned numbers.
void Generator::wide_comparison(const BinaryOperation& operation) {
    const Operator kind = operation.operation;
    const Wide left = wide(*operation.left), right = wide(*operation.right);
    stack_ = 0;
    if (kind == Operator::after) {
        const Wide distance{.cell = temporary(2)};
        wide_difference(left, right, false, distance.cell);
        return wide_greater(distance, {.constant = 0});
    }
    if (kind == Operator::equal || kind == Operator::unequal) {
        for (int part = 0; part < 2; ++part) {
            load_part(left, part);
            load_part(right, part);
            op(Operation::diff);
        }
        op(Operation::or_);
        op(Operation::eqc, 0);
        return kind == Operator::unequal ? op(Operation::eqc, 0) : void();
    }
    if (kind == Operator::greater || kind == Operator::less_or_equal)
        wide_greater(left, right);
    else
        wide_greater(right, left);
    if (kind == Operator::less_or_equal || kind == Operator::greater_or_equal)
        op(Operation::eqc, 0);
}

void Generator::wide_greater(const Wide& left, const Wide& right) {
    const Label lower = emitter_.new_label(), end = emitter_.new_label();
    const Cell result = temporary();
    load_part(left, 1);
    load_part(right, 1);
    op(Operation::diff);
    op(Operation::eqc, 0);
    op(Operation::eqc, 0);
    jump_if_false(lower);
    stack_ = 0;
    load_part(left, 1);
    load_part(right, 1);
    op(Operation::gt);
    store(result);
    jump(end);
    mark(lower);
    stack_ = 0;
    for (const Wide& each : {left, right}) {
        load_part(each, 0);
        op(Operation::mint);
        op(Operation::xor_);
    }
    op(Operation::gt);
    store(result);
    mark(end);
    load(result);
}

/// Converts an INT64 to a value of at most 32 bits.
void Generator::narrow(const Expression& operand, const Type& to) {
    const Wide value = wide(operand);
    load_part(value, 1);
    load_part(value, 0);
    if (options_.range_checks) {
        op(Operation::csngl);
        fails("{ba} does not fit in " + name_of(plain(to)));
    } else {
        stack_ = 1;
    }
    if (size_of(to) < 4)
        fit(to, true);
}

} // namespace placedpar::occam
