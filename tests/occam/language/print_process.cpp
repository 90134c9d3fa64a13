#include "tests/occam/language/printer.hpp"

namespace placedpar::occam {

namespace {

/// Returns the text without blanks at its start.
std::string without_indentation(const std::string& text) { return text.substr(text.find_first_not_of(' ')); }

} // namespace

/// Appends a line. Lines of value processes in it are indented as far as the first of them begins.
void Printer::line(const std::string& text) {
    text_ += std::string(indentation_, ' ');
    std::vector<std::size_t> indentations;
    for (const char c : text)
        if (c == lines_begin)
            indentations.push_back(text_.size() - (text_.rfind('\n') + 1));
        else if (c == lines_end)
            indentations.pop_back();
        else if (text_ += c; c == '\n')
            text_ += std::string(indentations.back(), ' ');
    text_ += '\n';
}

void Printer::below(const Process& each) {
    indentation_ += 2;
    process(each);
    indentation_ -= 2;
}

void Printer::process(const Process& each) {
    std::visit([this](const auto& form) { put(form); }, each.form);
}

std::string Printer::replicator(const std::optional<Replicator>& each) {
    if (!each)
        return "";
    return " " + each->index->name + " = " + expression(each->base) + " FOR " + expression(each->count) +
           (each->step ? " STEP " + expression(*each->step) : "");
}

std::string Printer::items(const std::vector<Item>& all) {
    std::string text;
    for (const Item& each : all)
        text += (text.empty() ? "" : "; ") + expression(each.value) +
                (each.counted_array ? "::" + expression(*each.counted_array) : "");
    return text;
}

void Printer::put(const Assignment& each) { line(list(each.targets) + " := " + list(each.values)); }
void Printer::put(const Input& each) { line(expression(each.channel) + " ? " + items(each.items)); }
void Printer::put(const Delay& each) { line(expression(each.timer) + " ? AFTER " + expression(each.time)); }
void Printer::put(const Output& each) { line(expression(each.channel) + " ! " + items(each.items)); }
void Printer::put(const VariantInput& each) { variants(expression(each.channel) + " ? CASE", each); }

void Printer::variants(const std::string& head, const VariantInput& input) {
    const auto tag = [this](const Variant& each) {
        return each.tag + (each.items.empty() ? "" : "; " + items(each.items));
    };
    if (input.variants.size() == 1 && !input.variants.front().process)
        return line(head + " " + tag(input.variants.front()));
    line(head);
    indentation_ += 2;
    for (const Variant& each : input.variants) {
        declarations(each.declarations);
        line(tag(each));
        below(each.process);
    }
    indentation_ -= 2;
}

void Printer::put(const Sequence& each) {
    line((each.is_do ? "DO" : "SEQ") + replicator(each.replicator));
    for (const Process& one : each.processes)
        below(one);
}

void Printer::put(const Parallel& each) {
    const std::string kind = each.kind == Parallel::Kind::priority ? "PRI "
                             : each.kind == Parallel::Kind::placed ? "PLACED "
                                                                   : "";
    line(kind + "PAR" + replicator(each.replicator));
    for (const Process& one : each.processes)
        below(one);
}

void Printer::put(const If& each) {
    line("IF" + replicator(each.replicator));
    indentation_ += 2;
    for (const Choice& choice : each.choices) {
        declarations(choice.declarations);
        if (choice.nested)
            put(*choice.nested);
        else {
            line(expression(*choice.condition));
            below(choice.process);
        }
    }
    indentation_ -= 2;
}

void Printer::put(const Case& each) {
    line("CASE " + expression(each.selector));
    indentation_ += 2;
    for (const Option& option : each.options) {
        declarations(option.declarations);
        line(option.values.empty() ? "ELSE" : list(option.values));
        below(option.process);
    }
    indentation_ -= 2;
}

void Printer::put(const While& each) {
    line("WHILE " + expression(each.condition));
    below(each.process);
}

void Printer::put(const Alternation& each) {
    line((each.has_priority ? "PRI ALT" : "ALT") + replicator(each.replicator));
    indentation_ += 2;
    for (const Alternative& one : each.alternatives)
        alternative(one);
    indentation_ -= 2;
}

void Printer::alternative(const Alternative& each) {
    declarations(each.declarations);
    if (const auto* nested = std::get_if<std::unique_ptr<Alternation>>(&each.guard))
        return put(**nested);
    const std::string condition = each.condition ? expression(*each.condition) + " & " : "";
    if (const auto* input = std::get_if<VariantInput>(&each.guard))
        return variants(condition + expression(input->channel) + " ? CASE", *input);
    Printer guard(program_, indentation_);
    if (const auto* plain = std::get_if<Input>(&each.guard))
        guard.put(*plain);
    else if (const auto* delay = std::get_if<Delay>(&each.guard))
        guard.put(*delay);
    else
        guard.line("SKIP");
    text_ += std::string(indentation_, ' ') + condition + without_indentation(guard.text_);
    below(each.process);
}

void Printer::put(const Instance& each) { line(each.name + " (" + list(each.arguments) + ")"); }

void Printer::put(const Scope& each) {
    declarations(each.declarations);
    process(*each.process);
}

void Printer::put(const Processor& each) {
    line("PROCESSOR " + expression(each.number) + (each.type.empty() ? "" : " " + each.type));
    below(each.process);
}

void Printer::put(const Wiring& each) {
    std::visit([this](const auto& form) { put(form); }, each.form);
}

void Printer::put(const Connect& each) {
    const auto end = [this](const ConnectionEnd& one) {
        return expression(one.path) + (one.link ? "[link][" + expression(*one.link) + "]" : "");
    };
    line("CONNECT " + end(each.from) + " TO " + end(each.to) + (each.arc ? " WITH " + expression(*each.arc) : ""));
}

void Printer::put(const SetNode& each) {
    std::string names, values;
    for (const Setting& setting : each.settings) {
        names += (names.empty() ? "" : ", ") + setting.name;
        values += (values.empty() ? "" : ", ") + expression(setting.value);
    }
    line("SET " + expression(each.node) + " (" + names + " := " + values + ")");
}

void Printer::put(const MapOnto& each) {
    line("MAP " + list(each.mapped) + " ONTO " + expression(each.onto) +
         (each.priority ? " PRI " + expression(*each.priority) : ""));
}

void Printer::value_process(const ValueProcess& each) {
    declarations(each.declarations);
    line("VALOF");
    below(each.process);
    indentation_ += 2;
    line("RESULT " + list(each.results));
    indentation_ -= 2;
}

} // namespace placedpar::occam
