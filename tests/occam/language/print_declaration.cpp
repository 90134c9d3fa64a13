#include "tests/occam/language/printer.hpp"

namespace placedpar::occam {

namespace {

/// Returns whether two declarations were written as one: `INT a, b:`.
bool are_one(const Declaration& a, const Declaration& b) {
    const auto* first = std::get_if<Variable>(&a.form);
    const auto* second = std::get_if<Variable>(&b.form);
    return first && second && first->type == second->type && !first->initial && !second->initial;
}

std::string direction(const std::optional<bool>& is_output) { return is_output ? *is_output ? "!" : "?" : ""; }

} // namespace

void Printer::declarations(const std::vector<DeclarationBox>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::string names = all[i]->name;
        const Declaration& first = *all[i];
        for (; i + 1 < all.size() && are_one(first, *all[i + 1]); ++i)
            names += ", " + all[i + 1]->name;
        declaration(first, names);
    }
}

void Printer::declaration(const Declaration& each, const std::string& names) {
    std::visit([&](const auto& form) { put(each, names, form); }, each.form);
}

void Printer::put(const Declaration&, const std::string& names, const Variable& variable) {
    line((variable.initial ? "INITIAL " : "") + type(*variable.type) + " " + names +
         (variable.initial ? " IS " + expression(*variable.initial) : "") + ":");
}

void Printer::put(const Declaration& each, const std::string&, const Abbreviation& abbreviation) {
    line((abbreviation.is_value ? "VAL " : "") + (abbreviation.type ? type(*abbreviation.type) + " " : "") + each.name +
         direction(abbreviation.written_output) + " IS " + expression(abbreviation.value) + ":");
}

void Printer::put(const Declaration& each, const std::string&, const Retyping& retyping) {
    line((retyping.is_value ? "VAL " : "") + type(*retyping.type) + " " + each.name +
         (retyping.reshapes ? " RESHAPES " : " RETYPES ") + expression(retyping.value) + ":");
}

std::string Printer::parameters(const std::vector<DeclarationBox>& all) {
    std::string text;
    const Parameter* last = nullptr;
    for (const DeclarationBox& each : all) {
        const auto& parameter = std::get<Parameter>(each->form);
        text += text.empty() ? "" : ", ";
        if (!last || last->type != parameter.type || last->passing != parameter.passing)
            text += (parameter.passing == Parameter::Passing::value    ? "VAL "
                     : parameter.passing == Parameter::Passing::result ? "RESULT "
                                                                       : "") +
                    type(*parameter.type) + " ";
        text += each->name + direction(parameter.written_output);
        last = &parameter;
    }
    return "(" + text + ")";
}

void Printer::put(const Declaration& each, const std::string&, const Procedure& procedure) {
    line((procedure.is_inline ? "INLINE PROC " : "PROC ") + each.name + " " + parameters(procedure.parameters));
    below(procedure.body);
    line(":");
}

void Printer::put(const Declaration& each, const std::string&, const Function& function) {
    std::string head;
    for (const auto& result : function.results)
        head += (head.empty() ? "" : ", ") + type(*result);
    head +=
        (function.is_inline ? " INLINE FUNCTION " : " FUNCTION ") + each.name + " " + parameters(function.parameters);
    if (!function.body.process)
        return line(head + " IS " + list(function.body.results) + ":");
    line(head);
    indentation_ += 2;
    value_process(function.body);
    indentation_ -= 2;
    line(":");
}

void Printer::put(const Declaration& each, const std::string&, const Protocol& form) {
    if (!form.is_variant)
        return line("PROTOCOL " + each.name + " IS " + protocol(form.items) + ":");
    line("PROTOCOL " + each.name);
    line("  CASE");
    for (const TagText& tag : form.tags) {
        std::string text = "    " + tag.name;
        for (const ItemText& one : tag.items)
            text += "; " + item(one);
        line(text);
    }
    line(":");
}

void Printer::put(const Declaration& each, const std::string&, const DataType& data_type) {
    if (data_type.is)
        return line("DATA TYPE " + each.name + " IS " + type(*data_type.is) + ":");
    line("DATA TYPE " + each.name);
    line(data_type.is_packed ? "  PACKED RECORD" : "  RECORD");
    for (const DataType::FieldText& field : data_type.fields)
        line("    " + type(*field.type) + " " + field.name + ":");
    line(":");
}

void Printer::put(const Declaration&, const std::string&, const Placement& placement) {
    const std::string where = placement.where == Placement::Where::workspace      ? "IN WORKSPACE"
                              : placement.where == Placement::Where::vector_space ? "IN VECSPACE"
                              : placement.where == Placement::Where::arc          ? "ON "
                                                                                  : "AT ";
    line("PLACE " + list(placement.paths) + " " + where + (placement.address ? expression(*placement.address) : "") +
         ":");
}

void Printer::put(const Declaration&, const std::string&, const Use& use) {
    line("#USE \"" + program_->units[use.unit]->name + "\"");
}

void Printer::put(const Declaration& each, const std::string&, const ConfigurationPart& part) {
    if (each.name == "PLACED")
        return process(*part.process);
    line(each.name);
    below(part.process);
    line(":");
}

std::string print(const Program& program) {
    Printer printer(&program);
    printer.declarations(program.declarations);
    return printer.take();
}

std::string print(const Program& program, const Unit& unit) {
    Printer printer(&program);
    printer.declarations(unit.declarations);
    return printer.take();
}

std::string print(const Expression& expression) { return Printer(nullptr).expression(expression); }

std::string print(const TypeText& type) { return Printer(nullptr).type(type); }

} // namespace placedpar::occam
