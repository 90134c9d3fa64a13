#include "occam/code/generator.hpp"

#include <algorithm>

namespace placedpar::occam {

using transputer::Operation;

void Generator::expression(const Expression& e) {
    if (const auto value = constant_of(e))
        return constant(*value);
    if (const auto routine = real_routine(e))
        return call_real_routine(e, *routine, {});
    if (const auto* unary_operation = std::get_if<UnaryOperation>(&e.form))
        return unary(*unary_operation);
    if (const auto* operation = std::get_if<BinaryOperation>(&e.form))
        return binary(*operation);
    if (const auto* converted = std::get_if<Conversion>(&e.form))
        return conversion(e, *converted);
    if (std::holds_alternative<Call>(e.form))
        return call_function(e, {});
    if (const auto* values = std::get_if<ValueProcess>(&e.form))
        return value_process(*values, [&] { expression(values->results.front()); });
    load(locate(e));
}

int Generator::depth_of(const Expression& e) const {
    if (constant_of(e))
        return 1;
    if (real_routine(e))
        return 3;
    const bool is_short = is_word(*e.type) && size_of(*e.type) == 2;
    if (const auto* operation = std::get_if<UnaryOperation>(&e.form)) {
        if (operation->operation == Operator::size)
            return 1;
        return std::max(depth_of(*operation->operand), is_short ? 3 : 2);
    }
    if (const auto* operation = std::get_if<BinaryOperation>(&e.form))
        return depth_of_binary(*operation);
    if (const auto* converted = std::get_if<Conversion>(&e.form))
        return depth_of_conversion(*converted);
    if (std::holds_alternative<Call>(e.form) || std::holds_alternative<ValueProcess>(e.form))
        return 3;
    return is_short ? 3 : depth_of_location(e);
}

int Generator::depth_of_conversion(const Conversion& converted) const {
    return is_word(*converted.operand->type) ? std::max(depth_of(*converted.operand), 2) : 3;
}

int Generator::depth_of_binary(const BinaryOperation& operation) const {
    const Type& type = *operation.left->type;
    if (!is_word(type) || size_of(type) == 2)
        return 3;
    const int left = depth_of(*operation.left), right = depth_of(*operation.right);
    if (operation.operation == Operator::logical_and || operation.operation == Operator::logical_or)
        return std::max(left, right);
    const bool shifts = operation.operation == Operator::shift_left || operation.operation == Operator::shift_right;
    if (shifts && !constant_of(*operation.right))
        return 3;
    const int both = left == right ? std::min(left + 1, 3) : std::max(left, right);
    return std::max(both, size_of(type) == 4 ? 2 : 3);
}

/// Loads the values of two expressions, with that of `right` on top of the register stack. `more` is the number of
/// further registers in use while `right` is loaded.
void Generator::operands(const Expression& left, const Expression& right, bool commutes, int more) {
    const int left_depth = depth_of(left), right_depth = std::max(depth_of(right), 1 + more);
    const bool left_first = left_depth <= registers() && right_depth + 1 <= registers();
    const bool right_first = right_depth <= registers() && left_depth + 1 <= registers() && more == 0;
    if (left_first && !(commutes && right_first && left_depth < right_depth)) {
        expression(left);
        expression(right);
    } else if (right_first) {
        expression(right);
        expression(left);
        if (!commutes)
            op(Operation::rev);
    } else {
        expression(right);
        const Cell saved = temporary();
        store(saved);
        expression(left);
        load(saved);
    }
}

void Generator::binary(const BinaryOperation& operation) {
    const Type& type = *operation.left->type;
    switch (operation.operation) {
    case Operator::logical_and:
    case Operator::logical_or: return logical(operation);
    case Operator::equal:
    case Operator::unequal:
    case Operator::less:
    case Operator::greater:
    case Operator::less_or_equal:
    case Operator::greater_or_equal:
    case Operator::after:
        return is_real(type)   ? real_comparison(operation)
               : is_wide(type) ? wide_comparison(operation)
                               : comparison(operation);
    case Operator::shift_left:
    case Operator::shift_right: return shift(operation);
    default: break;
    }
    if (arithmetic_with_constant(operation))
        return;
    const bool commutes = operation.operation != Operator::subtract && operation.operation != Operator::minus &&
                          operation.operation != Operator::divide && operation.operation != Operator::remainder;
    operands(*operation.left, *operation.right, commutes);
    arithmetic(operation.operation);
    const bool wraps = operation.operation == Operator::plus || operation.operation == Operator::minus ||
                       operation.operation == Operator::times;
    fit(type, !wraps);
}

/// If the operation adds or subtracts a constant, generates the instruction adc and returns true.
bool Generator::arithmetic_with_constant(const BinaryOperation& operation) {
    const auto left = constant_of(*operation.left), right = constant_of(*operation.right);
    const bool adds = operation.operation == Operator::add, subtracts = operation.operation == Operator::subtract;
    if (!(adds && (left || right)) && !(subtracts && right && *right != -(std::int64_t{1} << 31)))
        return false;
    const std::int64_t value = subtracts ? -*right : right ? *right : *left;
    if (value < -0xff'ffff || value > 0xff'ffff)
        return false;
    expression(right ? *operation.left : *operation.right);
    if (value != 0)
        op(Operation::adc, value);
    fit(*operation.left->type, true);
    return true;
}

void Generator::arithmetic(Operator operation) {
    switch (operation) {
    case Operator::add: return op(Operation::add);
    case Operator::subtract: return op(Operation::sub);
    case Operator::multiply: return op(Operation::mul);
    case Operator::divide: return op(Operation::div);
    case Operator::remainder: return op(Operation::rem);
    case Operator::plus: return op(Operation::bsub);
    case Operator::minus: return op(Operation::diff);
    case Operator::times: return op(Operation::prod);
    case Operator::bit_and: return op(Operation::and_);
    case Operator::bit_or: return op(Operation::or_);
    default: return op(Operation::xor_);
    }
}

/// Makes a result fit a type that is shorter than a word. If `checked`, generates a check of the range; otherwise
/// clears the higher bits.
void Generator::fit(const Type& given, bool checked) {
    const Type& type = plain(given);
    if (type.is(Basic::int16)) {
        if (!checked) {
            constant(0xffff);
            op(Operation::and_);
        }
        constant(0x8000);
        const bool is_checked = checked && options_.range_checks;
        op(is_checked ? Operation::cword : Operation::xword);
        if (is_checked)
            fails("{b} does not fit in INT16");
    } else if (type.is(Basic::byte)) {
        if (checked && !options_.range_checks)
            return;
        constant(checked ? 256 : 255);
        op(checked ? Operation::csub0 : Operation::and_);
        if (checked)
            fails("{b} does not fit in BYTE");
    } else if (type.is(Basic::boolean) && checked && options_.range_checks) {
        constant(2);
        op(Operation::csub0);
        fails("{b} does not fit in BOOL");
    }
}

void Generator::shift(const BinaryOperation& operation) {
    const Type& type = plain(*operation.left->type);
    const bool left = operation.operation == Operator::shift_left;
    const std::int64_t bits = 8 * size_of(type);
    const bool masks = !left && bits == 16;
    if (const auto places = constant_of(*operation.right)) {
        expression(*operation.left);
        if (masks) {
            constant(0xffff);
            op(Operation::and_);
        }
        constant(*places);
    } else {
        operands(*operation.left, *operation.right, false, options_.range_checks ? 1 : 0);
        if (options_.range_checks) {
            constant(bits + 1);
            op(Operation::csub0);
            fails("the shift count is {b}, but must be 0 to {a-1}");
        }
        if (masks) {
            op(Operation::rev);
            constant(0xffff);
            op(Operation::and_);
            op(Operation::rev);
        }
    }
    op(left ? Operation::shl : Operation::shr);
    if (bits < 32)
        fit(type, false);
}

void Generator::comparison(const BinaryOperation& operation) {
    const Expression &left = *operation.left, &right = *operation.right;
    switch (operation.operation) {
    case Operator::equal:
    case Operator::unequal: {
        const Expression& last = constant_of(left) ? left : right;
        const Expression& first = constant_of(left) ? right : left;
        const auto value = constant_of(last);
        if (value) {
            expression(first);
        } else {
            operands(first, last, true);
            op(Operation::diff);
        }
        op(Operation::eqc, value ? static_cast<std::int32_t>(*value) : 0);
        if (operation.operation == Operator::unequal)
            op(Operation::eqc, 0);
        return;
    }
    case Operator::less: operands(right, left, false); return op(Operation::gt);
    case Operator::greater: operands(left, right, false); return op(Operation::gt);
    case Operator::less_or_equal:
        operands(left, right, false);
        op(Operation::gt);
        return op(Operation::eqc, 0);
    case Operator::greater_or_equal:
        operands(right, left, false);
        op(Operation::gt);
        return op(Operation::eqc, 0);
    default:
        operands(left, right, false);
        op(Operation::diff);
        fit(*left.type, false);
        constant(0);
        return op(Operation::gt);
    }
}

void Generator::logical(const BinaryOperation& operation) {
    const bool is_or = operation.operation == Operator::logical_or;
    const Label end = emitter_.new_label();
    expression(*operation.left);
    if (is_or)
        op(Operation::eqc, 0);
    settle();
    jump_if_false(end);
    expression(*operation.right);
    if (is_or)
        op(Operation::eqc, 0);
    mark(end);
    if (is_or)
        op(Operation::eqc, 0);
}

void Generator::unary(const UnaryOperation& operation) {
    const Expression& operand = *operation.operand;
    switch (operation.operation) {
    case Operator::size: return size_of_array(operand);
    case Operator::logical_not: expression(operand); return op(Operation::eqc, 0);
    case Operator::bit_not:
        expression(operand);
        op(Operation::not_);
        return plain(*operand.type).is(Basic::byte) ? fit(*operand.type, false) : void();
    default: break;
    }
    const bool checked = operation.operation == Operator::negate;
    if (depth_of(operand) < registers()) {
        constant(0);
        expression(operand);
    } else {
        expression(operand);
        constant(0);
        op(Operation::rev);
    }
    op(checked ? Operation::sub : Operation::diff);
    if (checked && size_of(*operand.type) == 4)
        fails("overflow: -({a})");
    fit(*operand.type, checked);
}

void Generator::size_of_array(const Expression& array) {
    if (const auto* name = std::get_if<NameUse>(&array.form))
        return load_extent(outer_extent(bindings_.at(name->meaning)));
    const Storage location = locate(array);
    if (!location.is_static()) {
        store(temporary()); // the address is not needed
    }
    load_extent(outer_extent(location));
}

void Generator::conversion(const Expression& e, const Conversion& converted) {
    const Type &from = plain(*converted.operand->type), &to = plain(*e.type);
    if (is_real(from))
        return real_to_integer(converted, to);
    if (is_wide(from))
        return narrow(*converted.operand, to);
    expression(*converted.operand);
    if (size_of(to) < size_of(from) || to.is(Basic::boolean) || (to.is(Basic::byte) && from.is(Basic::int16)) ||
        (to.is(Basic::byte) && from.is(Basic::byte)))
        fit(to, true);
}

void Generator::condition(const Expression& e, Label if_false) {
    if (const auto value = constant_of(e)) {
        if (*value == 0)
            jump(if_false);
        return;
    }
    if (const auto* operation = std::get_if<BinaryOperation>(&e.form)) {
        if (operation->operation == Operator::logical_and) {
            condition(*operation->left, if_false);
            return condition(*operation->right, if_false);
        }
        if (operation->operation == Operator::logical_or) {
            const Label right = emitter_.new_label(), end = emitter_.new_label();
            expression(*operation->left);
            op(Operation::eqc, 0);
            settle();
            jump_if_false(end);
            mark(right);
            condition(*operation->right, if_false);
            return mark(end);
        }
    }
    expression(e);
    settle();
    jump_if_false(if_false);
}

void Generator::push(const std::vector<const Expression*>& values) {
    std::vector<std::optional<Cell>> saved(values.size());
    bool earlier = false; // whether a later value has already been evaluated
    for (std::size_t i = values.size(); i-- > 0;) {
        const int depth = depth_of(*values[i]);
        if (depth + static_cast<int>(i) > registers() || (earlier && depth > 1)) {
            expression(*values[i]);
            saved[i] = temporary();
            store(*saved[i]);
            earlier = true;
        }
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (saved[i])
            load(*saved[i]);
        else
            expression(*values[i]);
}

void Generator::value_process(const ValueProcess& values, const std::function<void()>& results) {
    const Kept top(frame_->top);
    const Kept vector(level_->vector_now);
    for (const DeclarationBox& each : values.declarations)
        declare(*each);
    if (values.process)
        process(*values.process);
    const Placed placed(emitter_, values.results_at);
    results();
}

} // namespace placedpar::occam
