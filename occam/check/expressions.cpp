#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"
#include "text/nearest.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

/// Returns a text for messages about a name that has no value, such as "a protocol"; "" if the name has a value.
std::string kind_of(const Declaration& declaration) {
    const auto& form = declaration.form;
    if (std::holds_alternative<Procedure>(form))
        return "a procedure";
    if (std::holds_alternative<Function>(form))
        return "a function; write its arguments after it";
    if (std::holds_alternative<Protocol>(form))
        return "a protocol";
    if (std::holds_alternative<DataType>(form))
        return "a type";
    const auto* predefined = std::get_if<Predefined>(&form);
    return predefined ? "predefined; write its arguments after it" : "";
}

bool is_mistaken(const Type& type) { return innermost(type).kind == Type::Kind::mistaken; }

/// Returns the reason why a variable cannot be written to; "" if it can.
std::string reason_not_writable(const Declaration& declaration) {
    if (std::holds_alternative<ReplicatorIndex>(declaration.form))
        return "is the index of a replicator";
    const auto* abbreviation = std::get_if<Abbreviation>(&declaration.form);
    const auto* retyping = std::get_if<Retyping>(&declaration.form);
    if ((abbreviation && abbreviation->is_value) || (retyping && retyping->is_value))
        return "is a VAL";
    const auto* parameter = std::get_if<Parameter>(&declaration.form);
    return parameter && parameter->passing == Parameter::Passing::value ? "is a VAL parameter" : "";
}

/// Returns the first name in an expression, for a hint about a conversion. Returns "(...)" if the expression contains
/// neither a name nor an operation on a name.
std::string short_text(const Expression& expression) {
    if (const auto* use = std::get_if<NameUse>(&expression.form))
        return use->name;
    const auto* binary = std::get_if<BinaryOperation>(&expression.form);
    const std::string left = binary ? short_text(*binary->left) : "(...)";
    return binary && left == "(...)" ? short_text(*binary->right) : left;
}

} // namespace

const Type* Checker::check(Expression& expression) {
    if (auto* call = std::get_if<Call>(&expression.form); call && call->arguments.size() == 1) {
        const Declaration* const named = names_.find(call->name);
        if (named && std::holds_alternative<DataType>(named->form)) {
            auto to = std::make_shared<TypeText>(TypeText{expression.at, {}, TypeText::Named{call->name}});
            auto operand = std::make_unique<Expression>(std::move(call->arguments[0]));
            expression.form = Conversion{std::move(to), Conversion::Rounding::none, std::move(operand)};
        }
    }
    expression.constant.reset(); // a configuration is checked again for each value of a replicator
    const bool several = std::exchange(several_allowed_, false);
    const bool gives_several =
        std::holds_alternative<Call>(expression.form) || std::holds_alternative<ValueProcess>(expression.form);
    several_allowed_ = several && gives_several;
    expression.type = std::visit([&](auto& form) { return form_of(expression, form); }, expression.form);
    several_allowed_ = false;
    return expression.type;
}

const Type* Checker::value(Expression& expression) {
    const Type* const type = check(expression);
    if (is_mistaken(*type) || is_data(*type))
        return type;
    report(expression.at, name_of(*type) + " has no value", "read a value from it by an input");
    return expression.type = mistaken();
}

void Checker::value_of(Expression& expression, const Type* wanted, const std::string& role) {
    value(expression);
    agrees(expression, wanted, role);
}

void Checker::constant_of_type(Expression& expression, const Type* wanted, const std::string& role) {
    value_of(expression, wanted, role);
    if (!expression.constant && !is_mistaken(*expression.type))
        report(expression.at, role + " must be a constant", "");
}

bool Checker::agrees(Expression& expression, const Type* wanted, const std::string& role, std::string hint) {
    if (fits(*wanted, *expression.type))
        return true;
    if (adapt(expression, *wanted) && fits(*wanted, *expression.type))
        return true;
    const auto* use = std::get_if<NameUse>(&expression.form);
    if (!use || is_first(use->meaning, name_of(*wanted)))
        report(expression.at, role + " must be " + name_of(*wanted) + ", not " + name_of(*expression.type),
               hint.empty() ? conversion_hint(expression, *wanted) : std::move(hint));
    expression.type = mistaken();
    return false;
}

std::string Checker::conversion_hint(const Expression& expression, const Type& wanted) const {
    if (!expression.type || wanted.kind != Type::Kind::basic || plain(*expression.type).kind != Type::Kind::basic)
        return "";
    const Basic to = wanted.basic, from = plain(*expression.type).basic;
    const auto* literal = std::get_if<IntegerLiteral>(&expression.form);
    if (literal && to != Basic::boolean && !is_real(to) && from == Basic::integer)
        return "write " + std::to_string(literal->value) + "(" + name_of(to) + ")";
    if (is_real(to) || is_real(from)) {
        const bool is_possible =
            from != Basic::boolean && from != Basic::byte && to != Basic::boolean && to != Basic::byte;
        return is_possible ? "write " + name_of(to) + " ROUND " + short_text(expression) : "";
    }
    return to == Basic::boolean ? "" : "write " + name_of(to) + " " + short_text(expression);
}

const Type* Checker::variable(Expression& expression, const std::string& action) {
    const Type* const type = check(expression);
    if (is_mistaken(*type))
        return type;
    const Declaration* const root = root_of(expression);
    if (!root || !is_data(*type)) {
        report(expression.at, (root ? name_of(*type) : std::string("a value")) + " cannot be " + action,
               "write the name of a variable");
        return expression.type = mistaken();
    }
    const std::string reason = reason_not_writable(*root);
    if (!reason.empty()) {
        report(expression.at, "\"" + root->name + "\" cannot be " + action + ": it " + reason, "", root);
        return expression.type = mistaken();
    }
    assigned(base_of(root), expression.at, "");
    return type;
}

/// Records that the present routine changes a variable that is declared outside of it. Reports an error if the routine
/// is a function. Does nothing for a variable that is declared inside.
void Checker::assigned(const Declaration* base, const Place& place, const std::string& through) {
    const auto depth = depths_.find(base);
    if (routines_.empty() || (depth != depths_.end() && depth->second >= routines_.size()))
        return;
    Routine& routine = routines_.back();
    if (routine.is_function)
        report(place,
               "the function cannot change \"" + base->name + "\"" + through +
                   ", because the variable is declared outside of the function",
               "return the value as a result", base);
    else if (std::ranges::find(routine.assigned, base) == routine.assigned.end())
        routine.assigned.push_back(base);
}

const Type* Checker::form_of(Expression& expression, NameUse& use) {
    const Declaration* const found = find(use.name, expression.at);
    use.meaning = found;
    if (!found)
        return mistaken();
    const std::string kind = kind_of(*found);
    if (!kind.empty()) {
        if (is_first(found, "value"))
            report(expression.at, "\"" + use.name + "\" has no value: it is " + kind, "", found);
        return mistaken();
    }
    const bool is_outside = program_.is_configuration && !routines_.empty() && depths_[found] == 0 &&
                            std::holds_alternative<Variable>(found->form);
    if (is_outside && found->type && found->type->kind != Type::Kind::timer) {
        report(expression.at,
               "a PROC of a configuration cannot use \"" + use.name + "\", which is declared outside of the PROC",
               "make it a parameter of the PROC", found);
        return mistaken();
    }
    expression.constant = found->constant;
    return found->type ? found->type : mistaken();
}

const Type* Checker::literal_type(const Place& place, const std::optional<Basic>& type, const std::string& name,
                                  Basic by_default) {
    if (name.empty())
        return basic(type.value_or(by_default));
    const Type* const named = named_type({place, {}, TypeText::Named{name}}, name);
    if (named->kind == Type::Kind::mistaken || plain(*named).kind == Type::Kind::basic)
        return named;
    report(place, "a literal cannot have the type " + name, "");
    return mistaken();
}

const Type* Checker::form_of(Expression& expression, IntegerLiteral& literal) {
    const Type* const type = literal_type(expression.at, literal.type, literal.type_name, Basic::integer);
    if (type->kind == Type::Kind::mistaken)
        return type;
    if (is_real(plain(*type).basic)) {
        report(expression.at, "a literal of " + name_of(*type) + " needs a decimal point",
               "write " + std::to_string(literal.value) + ".0(" + name_of(*type) + ")");
        return type;
    }
    const std::string_view line = program_.files[expression.at.file]->line(expression.at.line);
    const bool is_pattern = expression.at.column <= line.size() && line[expression.at.column - 1] == '#';
    const Folded folded = integer_value(literal.value, plain(*type).basic, is_pattern, literal.negative_allowed);
    if (folded.error)
        report(expression.at, "the number " + std::string(folded.error) + " for " + name_of(*type),
               name_of(*type) + " goes up to " + std::to_string(most_positive(plain(*type).basic)));
    else
        expression.constant = Constant{folded.bits, nullptr};
    return type;
}

const Type* Checker::form_of(Expression& expression, RealLiteral& literal) {
    if (!literal.type && literal.type_name.empty()) {
        report(expression.at, "a real number needs its type",
               "write " + literal.digits + "(REAL32) or " + literal.digits + "(REAL64)");
        return mistaken();
    }
    const Type* const type = literal_type(expression.at, literal.type, literal.type_name, Basic::real32);
    if (type->kind == Type::Kind::mistaken)
        return type;
    if (!is_real(plain(*type).basic)) {
        report(expression.at, "a number with a decimal point cannot be " + name_of(*type), "");
        return type;
    }
    const Folded folded = real_value(literal.digits, plain(*type).basic);
    if (folded.error)
        report(expression.at, "the number " + std::string(folded.error) + " for " + name_of(*type), "");
    else
        expression.constant = Constant{folded.bits, nullptr};
    return type;
}

const Type* Checker::form_of(Expression& expression, StringLiteral& literal) {
    expression.constant =
        Constant{0, std::make_shared<std::vector<std::uint8_t>>(literal.bytes.begin(), literal.bytes.end())};
    return types_.array(basic(Basic::byte), static_cast<std::uint32_t>(literal.bytes.size()));
}

/// Returns the type of a table of channels `[c, d]`; null if the table has no channels.
const Type* Checker::channel_table(TableLiteral& table) {
    const Expression* first = table.elements.data();
    while (const auto* const subscript = first ? std::get_if<Subscript>(&first->form) : nullptr)
        first = subscript->array.get();
    const auto* const use = first ? std::get_if<NameUse>(&first->form) : nullptr;
    const Declaration* const found = use ? names_.find(use->name) : nullptr;
    if (!found || !found->type || innermost(*found->type).kind != Type::Kind::channel)
        return nullptr;
    const Type* const element = check(table.elements.front());
    for (Expression& each : table.elements)
        if (check(each) != element)
            agrees(each, element, "this element of the table");
    return types_.array(element, static_cast<std::uint32_t>(table.elements.size()));
}

const Type* Checker::form_of(Expression& expression, TableLiteral& table) {
    if (const Type* const channels = program_.has_channel_tables ? channel_table(table) : nullptr)
        return channels;
    const Type* const whole = table.type ? type_of(*table.type, Open::allowed) : nullptr;
    if (whole && plain(*whole).kind == Type::Kind::record)
        return record_literal(expression, table);
    const Type* element = nullptr;
    bool is_constant = true;
    std::vector<std::uint8_t> bytes;
    for (Expression& each : table.elements) {
        const Type* const type = value(each);
        if (is_mistaken(*type))
            element = type;
        else if (!element)
            element = type;
        else
            agrees(each, element, "this element of the table");
        is_constant &= each.constant && !is_mistaken(*each.type);
        if (is_constant)
            std::ranges::copy(memory_of(*each.constant, *each.type), std::back_inserter(bytes));
    }
    if (!element || is_mistaken(*element))
        return mistaken();
    if (is_constant)
        expression.constant = Constant{0, std::make_shared<std::vector<std::uint8_t>>(std::move(bytes))};
    const Type* const type = types_.array(element, static_cast<std::uint32_t>(table.elements.size()));
    if (whole && !fits(*whole, *type)) {
        report(expression.at, "this table is " + name_of(*type) + ", not " + name_of(*whole), "");
        return mistaken();
    }
    return whole && plain(*whole).count ? whole : type;
}

const Type* Checker::record_literal(Expression& expression, TableLiteral& table) {
    const Type* const type = type_of(*table.type, Open::refused);
    const std::vector<Field>& fields = plain(*type).fields;
    if (fields.size() != table.elements.size()) {
        report(expression.at,
               name_of(*type) + " has " + std::to_string(fields.size()) + " fields, not " +
                   std::to_string(table.elements.size()),
               "");
        return mistaken();
    }
    bool is_constant = true;
    std::vector<std::uint8_t> bytes(bytes_of(*type));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        Expression& each = table.elements[i];
        value_of(each, fields[i].type, "the field \"" + fields[i].name + "\"");
        is_constant &= each.constant && !is_mistaken(*each.type);
        if (is_constant)
            std::ranges::copy(memory_of(*each.constant, *each.type), bytes.begin() + fields[i].offset);
    }
    if (is_constant)
        expression.constant = Constant{0, std::make_shared<std::vector<std::uint8_t>>(std::move(bytes))};
    return type;
}

const Type* Checker::field_of(Expression& expression, Subscript& subscript, const Type& record) {
    const auto* use = std::get_if<NameUse>(&subscript.index->form);
    std::vector<std::string> names;
    for (const Field& field : plain(record).fields)
        names.push_back(field.name);
    const auto found = std::ranges::find(names, use ? use->name : "");
    if (found == names.end()) {
        report(subscript.index->at,
               use ? unknown_name("field", use->name, names, name_of(record) + " has no such field")
                   : "the subscript of a record must be the name of a field",
               "");
        return mistaken();
    }
    subscript.field = static_cast<std::uint32_t>(found - names.begin());
    const Field& field = plain(record).fields[*subscript.field];
    if (subscript.array->constant && subscript.array->constant->bytes)
        expression.constant = constant_of(*subscript.array->constant->bytes, field.offset, *field.type);
    return field.type;
}

void Checker::check_range(const Expression& at, std::int64_t first, std::int64_t count, std::int64_t size,
                          bool is_segment) {
    if (first >= 0 && count >= 0 && first <= size && count <= size - first)
        return;
    const std::string what = is_segment ? "the segment from " + std::to_string(first) + " for " + std::to_string(count)
                                        : "subscript " + std::to_string(first);
    report(at.at, what + " is outside of an array of size " + std::to_string(size),
           "the last element has the subscript " + std::to_string(size - 1));
}

const Type* Checker::form_of(Expression& expression, Subscript& subscript) {
    const Type* const type = check(*subscript.array);
    const Type& form = plain(*type);
    if (form.kind == Type::Kind::record)
        return field_of(expression, subscript, *type);
    value_of(*subscript.index, basic(Basic::integer), "a subscript");
    if (is_mistaken(*type))
        return mistaken();
    if (form.kind != Type::Kind::array) {
        report(expression.at, "only an array can have a subscript, but this is " + name_of(*type), "");
        return mistaken();
    }
    if (!subscript.index->constant || is_mistaken(*subscript.index->type))
        return form.element;
    const std::int64_t index = subscript.index->constant->bits;
    if (form.count)
        check_range(*subscript.index, index, 1, *form.count, false);
    const std::optional<Constant>& array = subscript.array->constant;
    if (array && array->bytes && form.count && index >= 0 && index < *form.count)
        expression.constant =
            constant_of(*array->bytes, static_cast<std::uint64_t>(index) * bytes_of(*form.element), *form.element);
    return form.element;
}

const Type* Checker::form_of(Expression& expression, Segment& segment) {
    const Type* const type = check(*segment.array);
    for (Expression* const each : {segment.from.get(), segment.count.get()}) {
        if (each)
            value_of(*each, basic(Basic::integer),
                     each == segment.from.get() ? "the start of a segment" : "the count of a segment");
    }
    const Type& form = plain(*type);
    if (is_mistaken(*type))
        return mistaken();
    if (form.kind != Type::Kind::array) {
        report(expression.at, "only an array has segments, but this is " + name_of(*type), "");
        return mistaken();
    }
    const auto known = [](const ExpressionBox& box) -> std::optional<std::int64_t> {
        return box && box->constant ? std::optional(box->constant->bits) : std::nullopt;
    };
    const std::optional<std::int64_t> first = segment.from ? known(segment.from) : 0;
    std::optional<std::int64_t> count = known(segment.count);
    if (!segment.count && form.count && first)
        count = *form.count - *first;
    if (count && (form.count || *count < 0))
        check_range(segment.count ? *segment.count : expression, first.value_or(0), *count, form.count.value_or(0),
                    true);
    if (!count || *count < 0)
        return types_.array(form.element, std::nullopt);
    const Type* const part = types_.array(form.element, static_cast<std::uint32_t>(*count));
    const std::optional<Constant>& array = segment.array->constant;
    if (array && array->bytes && first && form.count && *first >= 0 && *first + *count <= *form.count)
        expression.constant =
            constant_of(*array->bytes, static_cast<std::uint64_t>(*first) * bytes_of(*form.element), *part);
    return part;
}

/// Returns the type of a call's first result. A call with several results is allowed only in an assignment.
const Type* Checker::several(Expression& expression, const std::vector<const Type*>& results) {
    if (results.empty())
        return mistaken();
    if (results.size() > 1 && !several_allowed_) {
        report(expression.at,
               "this function has " + std::to_string(results.size()) + " results, but one value is needed here",
               "assign the results: a, b := ...");
        return mistaken();
    }
    return results[0];
}

const Type* Checker::form_of(Expression& expression, Call& call) {
    const bool several_here = std::exchange(several_allowed_, false);
    const Declaration* const found = find(call.name, expression.at);
    call.meaning = found;
    const auto* predefined = found ? std::get_if<Predefined>(&found->form) : nullptr;
    const bool is_function =
        found && (std::holds_alternative<Function>(found->form) || (predefined && !predefined->results.empty()));
    if (found && !is_function)
        report(expression.at, "\"" + call.name + "\" is not a function", "", found);
    if (is_function) {
        arguments(expression.at, call.name, call.arguments, formals_of(*found));
    } else {
        for (Expression& each : call.arguments)
            check(each);
    }
    several_allowed_ = several_here;
    return is_function ? several(expression, results_of(*found)) : mistaken();
}

const Type* Checker::form_of(Expression& expression, ValueProcess& process) {
    const bool several_here = std::exchange(several_allowed_, false);
    const std::size_t mark = names_.mark();
    enter_routine({.is_function = true});
    value_process(process);
    const std::vector<const Type*> results = types_of_results(process.results);
    leave_routine(mark);
    several_allowed_ = several_here;
    return several(expression, results);
}

} // namespace placedpar::occam
