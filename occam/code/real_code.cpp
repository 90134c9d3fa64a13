#include "occam/code/generator.hpp"

#include <algorithm>

namespace placedpar::occam {

using transputer::Operation;

namespace {

bool is_long(const Type& type) { return bytes_of(type) == 8; }

} // namespace

/// Loads a value onto the stack of the floating-point unit.
void Generator::real(const Expression& e) {
    if (const auto bits = constant_of(e); bits && *bits == 0) {
        op(is_long(*e.type) ? Operation::fpldzerodb : Operation::fpldzerosn);
        ++reals_;
    } else if (const auto* unary_operation = std::get_if<UnaryOperation>(&e.form); unary_operation && !bits) {
        real_negation(e, *unary_operation);
    } else if (const auto* operation = std::get_if<BinaryOperation>(&e.form); operation && !bits) {
        real_binary(*operation);
    } else if (const auto* converted = std::get_if<Conversion>(&e.form); converted && !bits) {
        real_conversion(e, *converted);
    } else if (std::holds_alternative<Call>(e.form) && !bits) {
        call_function(e, {});
        reals_ = 1;
    } else if (const auto* values = std::get_if<ValueProcess>(&e.form); values && !bits) {
        value_process(*values, [&] { real(values->results.front()); });
    } else {
        real_load(bits ? real_constant(e) : locate(e));
    }
}

/// Returns the location of a constant in the procedure's table of large constants.
Storage Generator::real_constant(const Expression& e) {
    auto& constants = level_->constants;
    const std::int64_t bits = *constant_of(e);
    std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(bits)};
    if (is_long(*e.type))
        words.push_back(static_cast<std::uint32_t>(bits >> 32));
    const auto known = std::search(constants.begin(), constants.end(), words.begin(), words.end()) - constants.begin();
    if (static_cast<std::size_t>(known) == constants.size())
        constants.insert(constants.end(), words.begin(), words.end());
    level_->uses_table = true;
    return {.base = Storage::Base::pointer, .cell = level_->table, .offset = 4 * known, .type = e.type};
}

void Generator::real_load(Storage location) {
    const bool two_words = is_long(*location.type);
    ++reals_;
    if (location.has_index && location.base != Storage::Base::computed) {
        load_base(location);
        add_offset(location.offset);
        return op(two_words ? Operation::fpldnldbi : Operation::fpldnlsni);
    }
    address(location);
    op(two_words ? Operation::fpldnldb : Operation::fpldnlsn);
}

void Generator::check_reals(const std::string& meaning) {
    if (!options_.run_time_checks)
        return;
    op(Operation::fpchkerror);
    if (!meaning.empty())
        fails(meaning);
}

/// Clears floating-point errors that stopped processes have left.
void Generator::begin_reals() {
    if (halts() || stack_ > 2)
        return;
    op(Operation::fptesterror);
}

void Generator::real_store(Storage location) {
    address(location);
    check_reals();
    settle();
    op(is_long(*location.type) ? Operation::fpstnldb : Operation::fpstnlsn);
    reals_ = 0;
}

int Generator::depth_of_real(const Expression& e) const {
    if (constant_of(e))
        return 1;
    if (const auto* operation = std::get_if<UnaryOperation>(&e.form))
        return std::max(depth_of_real(*operation->operand), 2);
    if (const auto* operation = std::get_if<BinaryOperation>(&e.form)) {
        const int left = depth_of_real(*operation->left), right = depth_of_real(*operation->right);
        return std::min(left == right ? left + 1 : std::max(left, right), 3);
    }
    if (const auto* converted = std::get_if<Conversion>(&e.form)) {
        if (is_real(*converted->operand->type))
            return depth_of_real(*converted->operand);
        return is_word(*converted->operand->type) && !disturbs_reals(*converted->operand) ? 1 : 3;
    }
    if (std::holds_alternative<Call>(e.form) || std::holds_alternative<ValueProcess>(e.form))
        return 3;
    return disturbs_reals(e) ? 3 : 1;
}

/// Returns whether an expression may use the floating-point unit, or call a function that does.
bool Generator::disturbs_reals(const Expression& e) const {
    if (e.constant || std::holds_alternative<NameUse>(e.form))
        return false;
    if (const auto* subscript = std::get_if<Subscript>(&e.form))
        return disturbs_reals(*subscript->array) || (!subscript->field && disturbs_reals(*subscript->index));
    const auto* operation = std::get_if<BinaryOperation>(&e.form);
    return !operation || is_real(*operation->left->type) || disturbs_reals(*operation->left) ||
           disturbs_reals(*operation->right);
}

/// Returns whether a value is in memory, at an address whose computation does not use the floating-point unit.
bool Generator::is_real_leaf(const Expression& e) const {
    if (const auto bits = constant_of(e))
        return *bits != 0;
    const bool in_memory = std::holds_alternative<NameUse>(e.form) || std::holds_alternative<Subscript>(e.form);
    return in_memory && !disturbs_reals(e);
}

void Generator::real_operands(const Expression& left, const Expression& right, bool commutes) {
    const int left_depth = depth_of_real(left), right_depth = depth_of_real(right), free = 3 - reals_;
    if (left_depth <= free && right_depth + 1 <= free) {
        real(left);
        real(right);
    } else if (right_depth <= free && left_depth + 1 <= free) {
        real(right);
        real(left);
        if (!commutes)
            op(Operation::fprev);
    } else {
        real(right);
        const Storage saved = in_workspace(*right.type);
        load_address(saved.cell);
        op(is_long(*right.type) ? Operation::fpstnldb : Operation::fpstnlsn);
        --reals_;
        real(left);
        real_load(saved);
    }
}

void Generator::real_binary(const BinaryOperation& operation) {
    const Expression &left = *operation.left, &right = *operation.right;
    const bool adds = operation.operation == Operator::add, multiplies = operation.operation == Operator::multiply;
    const bool two_words = is_long(*left.type);
    if ((adds || multiplies) && (is_real_leaf(right) || is_real_leaf(left))) {
        const Expression& leaf =
            is_real_leaf(right) && !(is_real_leaf(left) && depth_of_real(right) > 1) ? right : left;
        real(&leaf == &right ? left : right);
        address(constant_of(leaf) ? real_constant(leaf) : locate(leaf));
        return op(adds        ? two_words ? Operation::fpldnladddb : Operation::fpldnladdsn
                  : two_words ? Operation::fpldnlmuldb
                              : Operation::fpldnlmulsn);
    }
    if (operation.operation == Operator::remainder)
        return real_remainder(left, right);
    real_operands(left, right, adds || multiplies);
    op(adds                                        ? Operation::fpadd
       : multiplies                                ? Operation::fpmul
       : operation.operation == Operator::subtract ? Operation::fpsub
                                                   : Operation::fpdiv);
    --reals_;
}

/// Computes the remainder with fpremfirst and a loop of fpremstep, as the instruction set prescribes.
void Generator::real_remainder(const Expression& left, const Expression& right) {
    const Label again = emitter_.new_label(), done = emitter_.new_label();
    real_operands(left, right, false);
    op(Operation::fpremfirst);
    op(Operation::eqc, 0);
    jump_if_false(done);
    mark(again);
    op(Operation::fpremstep);
    jump_if_false(again);
    mark(done);
    --reals_;
    stack_ = 0;
}

void Generator::real_negation(const Expression& e, const UnaryOperation& operation) {
    const bool held = depth_of_real(*operation.operand) < 3 - reals_;
    const auto zero = [&] { op(is_long(*e.type) ? Operation::fpldzerodb : Operation::fpldzerosn); };
    if (held) {
        zero();
        ++reals_;
    }
    real(*operation.operand);
    if (!held) {
        zero();
        ++reals_;
        op(Operation::fprev);
    }
    op(Operation::fpsub);
    --reals_;
}

void Generator::real_conversion(const Expression& e, const Conversion& converted) {
    const Type &from = plain(*converted.operand->type), &to = plain(*e.type);
    const bool truncates = converted.rounding == Conversion::Rounding::truncate;
    const auto round = [&] {
        if (truncates)
            op(Operation::fpurz);
    };
    if (is_real(from)) {
        real(*converted.operand);
        if (is_long(from) == is_long(to))
            return;
        if (!is_long(to))
            round();
        return op(is_long(to) ? Operation::fpur32tor64 : Operation::fpur64tor32);
    }
    if (is_word(from)) {
        const Cell value = temporary();
        expression(*converted.operand);
        store(value);
        load_address(value);
        if (!is_long(to))
            round();
        op(is_long(to) ? Operation::fpi32tor64 : Operation::fpi32tor32);
        ++reals_;
        return;
    }
    const Wide value = wide_variable(wide(*converted.operand));
    load_address(value.cell);
    op(Operation::fpb32tor64);
    if (!is_long(to))
        op(Operation::fpunoround);
    load_address(value.cell.after(1));
    op(Operation::fpi32tor64);
    op(Operation::fpuexpinc32);
    if (!is_long(to))
        op(Operation::fpunoround);
    round();
    op(Operation::fpadd);
    ++reals_;
}

void Generator::real_comparison(const BinaryOperation& operation) {
    const Expression &left = *operation.left, &right = *operation.right;
    const bool exchanged = operation.operation == Operator::less || operation.operation == Operator::greater_or_equal;
    const bool equality = operation.operation == Operator::equal || operation.operation == Operator::unequal;
    begin_reals();
    stack_ = 0;
    real_operands(exchanged ? right : left, exchanged ? left : right, equality);
    reals_ = 0;
    op(equality ? Operation::fpeq : Operation::fpgt);
    check_reals();
    if (operation.operation == Operator::unequal || operation.operation == Operator::less_or_equal ||
        operation.operation == Operator::greater_or_equal)
        op(Operation::eqc, 0);
}

/// Returns what the error of a conversion to an integer means. If the real is computed for the conversion, an error of
/// its computation is noticed only at the conversion.
std::string Generator::misfit(const Expression& operand, const std::string& type) {
    const bool is_computed = !constant_of(operand) && !std::holds_alternative<NameUse>(operand.form) &&
                             !std::holds_alternative<Subscript>(operand.form) &&
                             !std::holds_alternative<Call>(operand.form);
    return "the real does not fit in " + type +
           (is_computed ? ", or its computation failed: overflow, division by zero, an infinity or a NaN" : "");
}

/// Converts a real to an integer of at most 32 bits.
void Generator::real_to_integer(const Conversion& converted, const Type& to) {
    begin_reals();
    stack_ = 0;
    real(*converted.operand);
    if (converted.rounding == Conversion::Rounding::truncate)
        op(Operation::fpurz);
    op(Operation::fprtoi32);
    const Cell result = temporary();
    load_address(result);
    check_reals(misfit(*converted.operand, "INT"));
    op(Operation::fpstnli32);
    reals_ = 0;
    load(result);
    if (size_of(to) < 4)
        fit(to, true);
}

/// Converts a real to an INT64: first computes the lower half, and then the upper half from the rest of the number.
void Generator::real_to_wide(const Conversion& converted, const Cell& to) {
    begin_reals();
    stack_ = 0;
    real(*converted.operand);
    if (!is_long(*converted.operand->type))
        op(Operation::fpur32tor64);
    if (converted.rounding == Conversion::Rounding::truncate)
        op(Operation::fpurz);
    op(Operation::fpint);
    op(Operation::fpuchki64);
    check_reals(misfit(*converted.operand, "INT64"));
    op(Operation::fpdup);
    load_address(to);
    op(Operation::fpstnli32);
    op(Operation::fpuexpdec32);
    op(Operation::fpurm);
    op(Operation::fpint);
    load_address(to.after(1));
    op(Operation::fpstnli32);
    reals_ = 0;
}

} // namespace placedpar::occam
