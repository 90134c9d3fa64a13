#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace placedpar::occam {

namespace {

/// Lists which operands an operator accepts.
enum class Operands : std::uint8_t { numbers, integers, truths, ordered, scalars };

struct OperatorTraits {
    const char* name;
    Operands operands;
    bool gives_truth;
};

/// Describes the operators, in the order of Operator.
constexpr std::array<OperatorTraits, 27> operator_traits = {{
    {"+", Operands::numbers, false},      {"-", Operands::numbers, false},      {"*", Operands::numbers, false},
    {"/", Operands::numbers, false},      {"\\", Operands::numbers, false},     {"PLUS", Operands::integers, false},
    {"MINUS", Operands::integers, false}, {"TIMES", Operands::integers, false}, {"/\\", Operands::integers, false},
    {"\\/", Operands::integers, false},   {"><", Operands::integers, false},    {"<<", Operands::integers, false},
    {">>", Operands::integers, false},    {"=", Operands::scalars, true},       {"<>", Operands::scalars, true},
    {"<", Operands::ordered, true},       {">", Operands::ordered, true},       {"<=", Operands::ordered, true},
    {">=", Operands::ordered, true},      {"AFTER", Operands::integers, true},  {"AND", Operands::truths, true},
    {"OR", Operands::truths, true},       {"-", Operands::numbers, false},      {"MINUS", Operands::integers, false},
    {"~", Operands::integers, false},     {"NOT", Operands::truths, true},      {"SIZE", Operands::scalars, false},
}};

const OperatorTraits& traits_of(Operator operation) { return operator_traits[static_cast<std::size_t>(operation)]; }

bool takes(Operands operands, Basic basic) {
    switch (operands) {
    case Operands::numbers: return basic != Basic::boolean;
    case Operands::integers: return is_integer(basic);
    case Operands::truths: return basic == Basic::boolean;
    case Operands::ordered: return basic != Basic::boolean;
    default: return true;
    }
}

bool is_wrong(const Type& type) { return innermost(type).kind == Type::Kind::mistaken; }

} // namespace

void Checker::become(Expression& expression, std::int64_t bits, const char* error) {
    if (error)
        report(expression.at, "this constant expression " + std::string(error), "");
    else
        expression.constant = Constant{bits, nullptr};
}

bool Checker::has_operator(const Expression& operand, Operator operation, const Type& type) {
    const OperatorTraits& traits = traits_of(operation);
    const Type& form = plain(type);
    const bool takes_byte = operation <= Operator::remainder ||
                            (operation >= Operator::bit_and && operation <= Operator::bit_xor) ||
                            traits.operands == Operands::ordered || traits.operands == Operands::scalars;
    if (form.kind == Type::Kind::basic && takes(traits.operands, form.basic) &&
        (form.basic != Basic::byte || takes_byte))
        return true;
    std::string hint;
    if (form.kind == Type::Kind::basic && form.basic == Basic::byte)
        hint = conversion_hint(operand, *basic(Basic::integer));
    else if (form.kind == Type::Kind::basic && is_real(form.basic) && traits.operands == Operands::integers)
        hint = operation == Operator::plus || operation == Operator::minus || operation == Operator::times
                   ? "write +, - or * for reals"
                   : "";
    report(operand.at, name_of(type) + " has no operator " + traits.name, hint);
    return false;
}

const Type* Checker::shift(Expression& expression, BinaryOperation& operation) {
    const Type* const type = value(*operation.left);
    value_of(*operation.right, basic(Basic::integer), "the count of a shift");
    if (is_wrong(*type) || !has_operator(*operation.left, operation.operation, *type))
        return mistaken();
    if (!is_wrong(*operation.right->type)) {
        fold_binary(expression, operation);
        check_count(expression, operation);
    }
    return type;
}

void Checker::fold_binary(Expression& expression, const BinaryOperation& operation) {
    if (!operation.left->constant || !operation.right->constant)
        return;
    const Folded folded = fold(operation.operation, plain(*operation.left->type).basic, operation.left->constant->bits,
                               operation.right->constant->bits);
    become(expression, folded.bits, folded.error);
}

/// Reports a constant shift count that is out of range.
void Checker::check_count(Expression& expression, const BinaryOperation& shift) {
    if (shift.left->constant || !shift.right->constant)
        return;
    const Folded folded = fold(shift.operation, plain(*shift.left->type).basic, 0, shift.right->constant->bits);
    if (folded.error)
        report(expression.at, "the count of this shift is out of range",
               "the count can be from 0 to the number of bits of the shifted value");
}

const Type* Checker::form_of(Expression& expression, BinaryOperation& operation) {
    if (operation.operation == Operator::shift_left || operation.operation == Operator::shift_right)
        return shift(expression, operation);
    const OperatorTraits& traits = traits_of(operation.operation);
    const Type* left = value(*operation.left);
    const Type* right = value(*operation.right);
    if (left != right && adapt(*operation.right, *left))
        right = operation.right->type;
    else if (left != right && adapt(*operation.left, *right))
        left = operation.left->type;
    const Type* const known = is_wrong(*left) ? right : left;
    if (is_wrong(*known))
        return traits.gives_truth ? basic(Basic::boolean) : mistaken();
    const Expression& first = is_wrong(*left) ? *operation.right : *operation.left;
    if (!is_wrong(*left) && !is_wrong(*right) && left != right) {
        std::string hint = conversion_hint(*operation.right, *left);
        if (left->is(Basic::byte) || (hint.empty() && right->kind == Type::Kind::basic))
            hint = conversion_hint(*operation.left, *right);
        report(expression.at,
               "the operands of " + std::string(traits.name) + " have different types: " + name_of(*left) + " and " +
                   name_of(*right),
               std::move(hint));
        return traits.gives_truth ? basic(Basic::boolean) : mistaken();
    }
    if (!has_operator(first, operation.operation, *known))
        return traits.gives_truth ? basic(Basic::boolean) : mistaken();
    if (left == right)
        fold_binary(expression, operation);
    return traits.gives_truth ? basic(Basic::boolean) : known;
}

const Type* Checker::size_of(Expression& expression, UnaryOperation& operation) {
    const Type* const type = check(*operation.operand);
    const Type& form = plain(*type);
    if (form.kind == Type::Kind::array && form.count)
        expression.constant = Constant{*form.count, nullptr};
    else if (form.kind != Type::Kind::array && !is_wrong(form))
        report(operation.operand->at, "SIZE needs an array, not " + name_of(*type), "");
    return basic(Basic::integer);
}

const Type* Checker::form_of(Expression& expression, UnaryOperation& operation) {
    if (operation.operation == Operator::size)
        return size_of(expression, operation);
    const Type* const type = value(*operation.operand);
    if (is_wrong(*type) || !has_operator(*operation.operand, operation.operation, *type))
        return mistaken();
    if (operation.operand->constant) {
        const auto* literal = std::get_if<IntegerLiteral>(&operation.operand->form);
        const bool is_least = literal && literal->negative_allowed && operation.operation == Operator::negate &&
                              operation.operand->constant->bits == most_negative(plain(*type).basic);
        const Folded folded = fold(operation.operation, plain(*type).basic, operation.operand->constant->bits);
        if (is_least)
            expression.constant = operation.operand->constant;
        else
            become(expression, folded.bits, folded.error);
    }
    return type;
}

const Type* Checker::form_of(Expression& expression, Conversion& conversion) {
    const Type* const to = type_of(*conversion.to, Open::refused);
    const Type* const from = value(*conversion.operand);
    if (is_wrong(*to) || is_wrong(*from))
        return to;
    const Type& target = plain(*to);
    const Type& source = plain(*from);
    if (target.kind != Type::Kind::basic || source.kind != Type::Kind::basic) {
        if (&target == &source) { // conversion between a DATA TYPE and the array or record from which it is derived
            expression.constant = conversion.operand->constant;
            return to;
        }
        report(expression.at, name_of(*from) + " cannot be converted to " + name_of(*to), "");
        return mistaken();
    }
    const bool is_rounded = conversion.rounding != Conversion::Rounding::none;
    const auto is_small = [](Basic b) { return b == Basic::boolean || b == Basic::byte; };
    const bool with_real = is_real(target.basic) || is_real(source.basic);
    const bool widens =
        source.basic == target.basic || (source.basic == Basic::real32 && target.basic == Basic::real64);
    std::string hint;
    bool is_allowed = with_real && (is_rounded ? !is_small(target.basic) && !is_small(source.basic) : widens);
    is_allowed |= !with_real && !is_rounded;
    if (!is_allowed) {
        if (with_real && is_small(source.basic) && source.basic == Basic::byte)
            hint = "convert it to INT first: " + name_of(*to) + " ROUND (INT ...)";
        else if (with_real && !is_rounded && !is_small(target.basic) && !is_small(source.basic))
            hint = "write " + name_of(*to) + " ROUND or " + name_of(*to) + " TRUNC";
        else if (!with_real)
            hint = "write " + name_of(*to) + " without ROUND or TRUNC, which are for reals";
        report(expression.at,
               name_of(*from) + " cannot be converted to " + name_of(*to) +
                   (is_rounded ? " with ROUND or TRUNC" : " in this way"),
               std::move(hint));
        return to;
    }
    if (conversion.operand->constant) {
        const Folded folded =
            convert(source.basic, target.basic, conversion.rounding, conversion.operand->constant->bits);
        become(expression, folded.bits, folded.error);
    }
    return to;
}

const Type* Checker::form_of(Expression& expression, TypeBound& bound) {
    const Type* const type = type_of(*bound.of, Open::refused);
    if (is_wrong(*type))
        return bound.which == TypeBound::Which::bytes_in ? basic(Basic::integer) : type;
    if (bound.which == TypeBound::Which::bytes_in) {
        if (is_data(*type))
            expression.constant = Constant{static_cast<std::int64_t>(bytes_of(*type)), nullptr};
        else
            report(expression.at, "BYTESIN needs a data type, not " + name_of(*type), "");
        return basic(Basic::integer);
    }
    const Type& form = plain(*type);
    if (form.kind != Type::Kind::basic || !is_integer(form.basic)) {
        report(expression.at, "MOSTPOS and MOSTNEG need an integer type, not " + name_of(*type), "");
        return mistaken();
    }
    const bool is_positive = bound.which == TypeBound::Which::most_positive;
    expression.constant = Constant{is_positive ? most_positive(form.basic) : most_negative(form.basic), nullptr};
    return type;
}

const Type* Checker::form_of(Expression& expression, OffsetOf& offset) {
    const Type* const type = type_of(*offset.of, Open::refused);
    const Type& form = plain(*type);
    const auto field = std::ranges::find(form.fields, offset.field, &Field::name);
    if (field != form.fields.end())
        expression.constant = Constant{field->offset, nullptr};
    else if (!is_wrong(*type))
        report(expression.at, name_of(*type) + " has no field \"" + offset.field + "\"", "");
    return basic(Basic::integer);
}

} // namespace placedpar::occam
