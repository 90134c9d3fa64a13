#include "netlist/complete/complete.hpp"
#include "netlist/network/names.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <cctype>

namespace placedpar {

namespace {

/// The real toolset's linked units and other files: farm.lku, farm.c8h, farm.lah, farm.tco ...
bool is_program_file(std::string_view name) {
    auto dot = name.rfind('.');
    if (dot == std::string_view::npos || name.size() - dot != 4)
        return false;
    auto extension = name.substr(dot + 1);
    if (extension == "lku" || extension == "lkd" || extension == "tco" || extension == "rsc" || extension == "btl")
        return true;
    static constexpr std::string_view forms = "clt", targets = "0123456789abce", modes = "hsxu";
    return forms.find(extension[0]) != std::string_view::npos && targets.find(extension[1]) != std::string_view::npos &&
           modes.find(extension[2]) != std::string_view::npos;
}

std::vector<std::string> kind_names(const Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const auto& [name, kind] : catalogue.kinds())
        names.push_back(name);
    return names;
}

const ProcessKind* find_kind(Completion& c, std::size_t index) {
    auto& process = c.draft.processes[index];
    auto used = process.used.value_or(c.draft.default_used);
    if (process.kind.empty())
        process.kind = c.draft.default_kind;
    const auto* kind = c.catalogue.find(process.kind);
    if (kind != nullptr || process.kind.empty() || is_program_file(process.kind))
        return kind;
    c.kind_refused[index] = true;
    auto guess = did_you_mean(process.kind, kind_names(c.catalogue));
    c.reporter.error(used, fmt::format("there is no process kind \"{}\"", process.kind),
                     guess.empty() ? "`placedpar kinds` lists them; a program file ends in .lku, .c8h and the like"
                                   : guess);
    return nullptr;
}

void check_port(Completion& c, const DraftProcess& process, const PortDeclaration& port, const ProcessKind& kind) {
    const auto* known = kind.port(port.name);
    if (known == nullptr) {
        std::vector<std::string> names;
        for (const auto& other : kind.ports)
            names.push_back(other.name);
        c.reporter.error(port.at, fmt::format("the kind \"{}\" has no channel \"{}\"", kind.name, port.name),
                         did_you_mean(port.name, names),
                         {{"it is used here", process.used.value_or(c.draft.default_used)}});
    } else if (known->direction != port.direction) {
        c.reporter.error(port.at,
                         fmt::format("the channel \"{}\" of the kind \"{}\" is an {}, not an {}", port.name, kind.name,
                                     word(known->direction), word(port.direction)),
                         "", {{"it is used here", process.used.value_or(c.draft.default_used)}});
    }
}

ParameterType type_of(const ParameterDeclaration& parameter) {
    if (parameter.type == "char" && !parameter.dimensions.empty())
        return ParameterType::text;
    return parameter.type == "float" || parameter.type == "double" ? ParameterType::real : ParameterType::integer;
}

const char* word(ParameterType type) {
    return type == ParameterType::integer ? "an integer (int)"
           : type == ParameterType::real  ? "real (double)"
                                          : "text (char [])";
}

void check_parameter(Completion& c, const DraftProcess& process, const ParameterDeclaration& parameter,
                     const ProcessKind& kind) {
    const auto* known = kind.parameter(parameter.name);
    std::vector<SecondPlace> others{{"it is used here", process.used.value_or(c.draft.default_used)}};
    if (known == nullptr) {
        std::vector<std::string> names;
        for (const auto& other : kind.parameters)
            names.push_back(other.name);
        c.reporter.error(parameter.at,
                         fmt::format("the kind \"{}\" has no parameter \"{}\"", kind.name, parameter.name),
                         did_you_mean(parameter.name, names), std::move(others));
    } else if (known->type != type_of(parameter)) {
        c.reporter.error(
            parameter.at,
            fmt::format("the parameter \"{}\" of the kind \"{}\" is {}", parameter.name, kind.name, word(known->type)),
            "", std::move(others));
    }
}

/// What the netlist's interface says must be in the kind, and the ports that the kind cannot do without must
/// be in the interface.
void check_interface(Completion& c, const DraftProcess& process, const ProcessKind& kind) {
    const auto& interface = *process.interface;
    for (const auto& port : interface.ports)
        check_port(c, process, port, kind);
    for (const auto& parameter : interface.parameters)
        check_parameter(c, process, parameter, kind);
    for (const auto& needed : kind.ports) {
        bool there = false;
        for (const auto& port : interface.ports)
            there = there || port.name == needed.name;
        if (!there && !needed.optional)
            c.reporter.error(process.declared,
                             fmt::format("the channel \"{}\" of the kind \"{}\" is missing in the interface of \"{}\"",
                                         needed.name, kind.name, process.name),
                             fmt::format("interface ({} {}, ...)", word(needed.direction), needed.name),
                             {{"it is used here", process.used.value_or(c.draft.default_used)}});
    }
}

} // namespace

void complete_processes(Completion& c) {
    const auto count = c.draft.processes.size();
    c.kinds.assign(count, nullptr);
    c.kind_refused.assign(count, false);
    c.network.processes.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto* kind = c.kinds[i] = find_kind(c, i);
        const auto& draft = c.draft.processes[i];
        if (draft.node == nowhere)
            c.reporter.error(draft.declared, fmt::format("the process \"{}\" is placed on no processor", draft.name),
                             fmt::format("place {} on ...;", draft.name));
        if (kind != nullptr && draft.interface)
            check_interface(c, draft, *kind);
        if (!c.kind_refused[i])
            complete_parameters(c, i);
        auto& process = c.network.processes[i];
        process.name = draft.name;
        process.kind = draft.kind;
        process.stand_in = kind == nullptr;
        process.high_priority = draft.high_priority;
        process.node = draft.node;
        process.other = draft.other;
        process.declared = draft.declared;
    }
}

} // namespace placedpar
