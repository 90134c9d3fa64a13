#include "occam/check/checker.hpp"
#include "occam/check/constant.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

bool is_wrong_type(const Type& type) { return innermost(type).kind == Type::Kind::mistaken; }

/// Returns whether two declarations belong to one list such as `INT a, b:`.
bool are_of_one_list(const Declaration& a, const Declaration& b) {
    const auto* first = std::get_if<Variable>(&a.form);
    const auto* second = std::get_if<Variable>(&b.form);
    return first && second && first->type && first->type == second->type && !first->initial;
}

/// Returns whether a declaration introduces a name. A PLACE, for example, refers to a name that is already declared.
bool is_named(const Declaration& declaration) {
    return !std::holds_alternative<Placement>(declaration.form) && !std::holds_alternative<Use>(declaration.form) &&
           !std::holds_alternative<ConfigurationPart>(declaration.form);
}

/// Returns the size of a value of the type in bytes, or nothing if the size is known only at run time.
std::optional<std::uint64_t> known_bytes(const Type& type) {
    if (plain(type).kind != Type::Kind::array)
        return bytes_of(type);
    const Type& array = plain(type);
    const std::optional<std::uint64_t> element = known_bytes(*array.element);
    return array.count && element ? std::optional(*array.count * *element) : std::nullopt;
}

} // namespace

void Checker::declare(DeclarationList& list) {
    pending_.push_back({&list, 0});
    for (DeclarationBox& declaration : list) {
        ++pending_.back().next;
        declare(*declaration);
        if (change_ && &list == &program_.declarations)
            change_(program_, *declaration);
    }
    pending_.pop_back();
}

void Checker::declare(Declaration& declaration) {
    std::visit([&](auto& form) { declare(declaration, form); }, declaration.form);
    if (!declaration.type)
        declaration.type = mistaken();
    if (!is_named(declaration))
        return;
    const Declaration* const earlier = names_.find(declaration.name);
    if (earlier && are_of_one_list(*earlier, declaration))
        report(declaration.at, "\"" + declaration.name + "\" is declared twice", "", earlier);
    add(declaration);
}

void Checker::declare(Declaration& declaration, Variable& variable) {
    declaration.type = variable.type ? type_of(*variable.type, Open::refused) : mistaken();
    if (!variable.initial)
        return;
    if (!is_wrong_type(*declaration.type) && !is_data(*declaration.type))
        report(declaration.at, name_of(*declaration.type) + " cannot have an initial value", "");
    else
        value_of(*variable.initial, declaration.type, "the initial value of \"" + declaration.name + "\"");
}

/// Checks the right side of an abbreviation without VAL: it must be a variable, a channel, a timer or a port.
const Type* Checker::abbreviated(Expression& expression) {
    const auto* table = program_.has_channel_tables ? nullptr : std::get_if<TableLiteral>(&expression.form);
    const auto* first = table && !table->elements.empty() ? std::get_if<NameUse>(&table->elements[0].form) : nullptr;
    const Declaration* const named = first ? names_.find(first->name) : nullptr;
    if (named && named->type && !is_data(*named->type)) {
        report(expression.at, "tables of channels are not supported", "declare an array of channels");
        return expression.type = mistaken();
    }
    const Type* const type = check(expression);
    if (is_wrong_type(*type))
        return type;
    if (!root_of(expression) && is_data(*type)) {
        report(expression.at, "an abbreviation of a value needs VAL", "begin the abbreviation with VAL");
        return expression.type = mistaken();
    }
    if (is_data(*type))
        return variable(expression, "abbreviated without VAL");
    if (expression.written_output)
        use_channel(expression, *expression.written_output ? Direction::output : Direction::input);
    return type;
}

void Checker::declare(Declaration& declaration, Abbreviation& abbreviation) {
    const Type* const wanted = abbreviation.type ? type_of(*abbreviation.type, Open::allowed) : nullptr;
    const Type* given = abbreviation.is_value ? value(abbreviation.value) : abbreviated(abbreviation.value);
    if (wanted && !agrees(abbreviation.value, wanted, "the value of \"" + declaration.name + "\""))
        given = wanted;
    else
        given = abbreviation.value.type;
    declaration.type = wanted && is_wrong_type(*given) ? wanted : given;
    if (wanted && plain(*wanted).count && !is_wrong_type(*given))
        declaration.type = wanted;
    if (abbreviation.is_value && !is_wrong_type(*abbreviation.value.type))
        declaration.constant = abbreviation.value.constant;
    if (abbreviation.written_output)
        declaration.direction = *abbreviation.written_output ? Direction::output : Direction::input;
}

/// Returns the type of a RETYPES. A dimension without a size gets its size from that of the value.
const Type* Checker::retyped(Declaration& declaration, Retyping& retyping, const Type& from) {
    const Type* const to = retyping.type ? type_of(*retyping.type, Open::allowed) : mistaken();
    if (is_wrong_type(*to) || is_wrong_type(from))
        return to;
    if (is_data(*to) != is_data(from)) {
        report(declaration.at, name_of(from) + " cannot be retyped as " + name_of(*to), "");
        return to;
    }
    if (!is_data(from))
        return to;
    if (retyping.reshapes && &innermost(*to) != &innermost(from))
        report(declaration.at,
               "RESHAPES cannot change the elements from " + name_of(innermost(from)) + " to " +
                   name_of(innermost(*to)),
               "write RETYPES");
    const std::optional<std::uint64_t> size = known_bytes(from), wanted = known_bytes(*to);
    if (!size)
        return to;
    if (wanted && *wanted != *size)
        report(declaration.at,
               "the sizes differ: " + name_of(from) + " has " + std::to_string(*size) + " bytes, and " + name_of(*to) +
                   " has " + std::to_string(*wanted),
               "");
    if (wanted || to->count)
        return to;
    const std::optional<std::uint64_t> element = known_bytes(*to->element);
    if (!element || *element == 0)
        return to;
    if (*size % *element != 0)
        report(declaration.at,
               name_of(from) + " has " + std::to_string(*size) + " bytes, which is not a multiple of the size of " +
                   name_of(*to->element),
               "");
    return types_.array(to->element, static_cast<std::uint32_t>(*size / *element));
}

void Checker::declare(Declaration& declaration, Retyping& retyping) {
    const Type* const from = retyping.is_value ? value(retyping.value) : abbreviated(retyping.value);
    declaration.type = retyped(declaration, retyping, *from);
    const std::optional<Constant>& constant = retyping.value.constant;
    if (!retyping.is_value || !constant || is_wrong_type(*from) || is_wrong_type(*declaration.type))
        return;
    const std::vector<std::uint8_t> memory = memory_of(*constant, *from);
    if (known_bytes(*declaration.type) == memory.size())
        declaration.constant = constant_of(memory, 0, *declaration.type);
}

void Checker::declare(Declaration& declaration, Parameter& parameter) {
    declaration.type = parameter.type ? type_of(*parameter.type, Open::allowed) : mistaken();
    if (is_wrong_type(*declaration.type))
        return;
    if (!is_data(*declaration.type) && parameter.passing != Parameter::Passing::reference)
        report(declaration.at, name_of(*declaration.type) + " cannot be passed as VAL or RESULT",
               "leave VAL or RESULT out");
    if (parameter.written_output)
        declaration.direction = *parameter.written_output ? Direction::output : Direction::input;
}

void Checker::parameters(DeclarationList& list) {
    std::map<std::string, const Declaration*> names;
    for (const DeclarationBox& each : list) {
        const auto [earlier, is_new] = names.emplace(each->name, each.get());
        if (!is_new)
            report(each->at, "the parameter \"" + each->name + "\" is declared twice", "", earlier->second);
    }
    declare(list);
    for (const DeclarationBox& each : list)
        if (names[each->name] != each.get()) // declared twice: its type is probably wrong, too
            each->type = mistaken();
}

void Checker::enter_routine(Routine routine) {
    routine.is_inside_priority_par = std::exchange(inside_priority_par_, false);
    routines_.push_back(std::move(routine));
}

void Checker::leave_routine(std::size_t mark) {
    names_.leave(mark);
    inside_priority_par_ = routines_.back().is_inside_priority_par;
    if (const Declaration* const declaration = routines_.back().declaration)
        effects_[declaration] = std::move(routines_.back());
    routines_.pop_back();
}

void Checker::declare(Declaration& declaration, Procedure& procedure) {
    const std::size_t mark = names_.mark();
    enter_routine({.declaration = &declaration});
    parameters(procedure.parameters);
    if (procedure.body)
        check(*procedure.body);
    leave_routine(mark);
}

void Checker::value_process(ValueProcess& process) {
    declare(process.declarations);
    if (process.process)
        check(*process.process);
}

std::vector<const Type*> Checker::types_of_values(std::vector<Expression>& values) {
    std::vector<const Type*> types;
    for (Expression& each : values) {
        several_allowed_ = values.size() == 1;
        types.push_back(value(each));
    }
    const auto* call = values.size() == 1 ? std::get_if<Call>(&values[0].form) : nullptr;
    const auto* process = values.size() == 1 ? std::get_if<ValueProcess>(&values[0].form) : nullptr;
    if (is_wrong_type(*types.front()))
        return types;
    if (call && call->meaning)
        return results_of(*call->meaning);
    if (process && process->results.size() > 1) {
        types.clear();
        for (const Expression& each : process->results)
            types.push_back(each.type);
    }
    return types;
}

std::vector<const Type*> Checker::types_of_results(std::vector<Expression>& results) {
    std::vector<const Type*> types;
    for (Expression& each : results)
        types.push_back(value(each));
    return types;
}

bool Checker::has_values(const Place& place, const std::string& role, std::vector<Expression>& values,
                         const std::vector<const Type*>& given, const std::vector<const Type*>& wanted) {
    if (given.size() != wanted.size()) {
        if (given.empty() || !is_wrong_type(*given.front()))
            report(place,
                   "wrong number of values for the " + role + ": expected " + std::to_string(wanted.size()) +
                       ", found " + std::to_string(given.size()),
                   "");
        return false;
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (values.size() == given.size())
            agrees(values[i], wanted[i], "the value");
        else if (!fits(*wanted[i], *given[i]))
            report(place,
                   "result " + std::to_string(i + 1) + " is " + name_of(*given[i]) + ", not " + name_of(*wanted[i]),
                   "");
    }
    return true;
}

void Checker::declare(Declaration& declaration, Function& function) {
    const std::size_t mark = names_.mark();
    enter_routine({.declaration = &declaration, .is_function = true});
    for (const std::shared_ptr<TypeText>& result : function.results) {
        const Type* const type = type_of(*result, Open::refused);
        if (!is_wrong_type(*type) && plain(*type).kind != Type::Kind::basic)
            report(result->at, "a function returns single values, not " + name_of(*type),
                   "use a PROC with a parameter");
        function.result_types.push_back(type);
    }
    for (const DeclarationBox& each : function.parameters) {
        if (std::get<Parameter>(each->form).passing != Parameter::Passing::value)
            report(each->at, "a parameter of a function must be VAL", "write VAL in front of its type");
    }
    parameters(function.parameters);
    value_process(function.body);
    if (!function.body.results.empty()) {
        const std::vector<const Type*> given = types_of_results(function.body.results);
        has_values(function.body.results[0].at, "results", function.body.results, given, function.result_types);
    }
    leave_routine(mark);
    declaration.type = function.result_types.empty() ? mistaken() : function.result_types.front();
}

void Checker::declare(Declaration& declaration, Protocol& protocol) {
    ProtocolType made{.kind = protocol.is_variant ? ProtocolType::Kind::variant : ProtocolType::Kind::sequence};
    if (protocol.is_variant) {
        add_tags(made, protocol);
    } else if (protocol.items.any) {
        made.kind = ProtocolType::Kind::any;
    } else {
        made.items = items_of(protocol.items.items);
        if (made.items.size() != protocol.items.items.size())
            return; // the error is reported; channels of this protocol have the type `mistaken`
    }
    protocol.meaning = shared_protocol(declaration, std::move(made));
}

void Checker::declare(Declaration& declaration, DataType& data) {
    if (!data.is) {
        declaration.type = record_type(declaration, data);
        return;
    }
    const Type* const element = type_of(*data.is, Open::refused);
    if (is_wrong_type(*element))
        declaration.type = element;
    else if (!is_data(*element))
        report(data.is->at, "a DATA TYPE cannot be " + name_of(*element), "");
    else
        declaration.type = types_.derived(&declaration, element);
}

void Checker::declare(Declaration& declaration, Placement& placement) {
    const bool is_whole = placement.paths.size() == 1 && std::holds_alternative<NameUse>(placement.paths[0].form);
    if (placement.where == Placement::Where::arc || !is_whole)
        return report(declaration.at, "a PLACE in a program takes the name of one variable or channel",
                      "only a configuration can place elements of an array, several channels, or a channel on an arc");
    if (placement.address)
        constant_of_type(*placement.address, basic(Basic::integer), "the address");
    Declaration* const placed = find(declaration.name, declaration.at);
    placement.placed = placed;
    if (!placed)
        return;
    declaration.type = placed->type;
    if (!std::holds_alternative<Variable>(placed->form))
        return report(declaration.at,
                      "\"" + placed->name + "\" cannot be placed: it is not a declared variable or channel", "",
                      placed);
    if (placed->placement)
        return report(declaration.at, "\"" + placed->name + "\" is placed twice", "", placed);
    placed->placement = &placement;
    const bool is_array = placed->type && plain(*placed->type).kind == Type::Kind::array;
    if (placement.where != Placement::Where::address && !is_array && !is_wrong_type(*placed->type))
        report(declaration.at, "only arrays can be placed in WORKSPACE or VECSPACE", "", placed);
}

void Checker::declare(Declaration&, Use& use) {
    if (use.unit >= program_.units.size())
        return;
    for (const DeclarationBox& each : program_.units[use.unit]->declarations) {
        if (is_named(*each))
            names_.add(*each);
    }
}

} // namespace placedpar::occam
