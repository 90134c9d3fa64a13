#include "netlist/complete/complete.hpp"
#include "netlist/complete/declared_type.hpp"
#include "netlist/network/names.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

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

const ProcessKind* find_kind(Completion& c, std::size_t index) {
    auto& process = c.draft.processes[index];
    auto used = process.used.value_or(c.draft.default_used);
    if (process.kind.empty())
        process.kind = c.draft.default_kind;
    const auto* kind = c.catalogue.find(process.kind);
    if (kind != nullptr || process.kind.empty() || is_program_file(process.kind))
        return kind;
    c.kind_refused[index] = true;
    auto guess = did_you_mean(process.kind, c.catalogue.kind_names());
    c.reporter.error(used, fmt::format("there is no process kind \"{}\"", process.kind),
                     guess.empty() ? "`placedpar kinds` lists them; a program file ends in .lku, .c8h and the like"
                                   : guess);
    return nullptr;
}

SecondPlace used_here(const Completion& c, const DraftProcess& process) {
    return {"it is used here", process.used.value_or(c.draft.default_used)};
}

void check_port(Completion& c, const DraftProcess& process, const PortDeclaration& port, const ProcessKind& kind) {
    const auto* known = kind.port(port.name);
    if (known == nullptr) {
        c.reporter.error(port.at, fmt::format("the kind \"{}\" has no channel \"{}\"", kind.name, port.name),
                         did_you_mean(port.name, names_in(kind.ports)), {used_here(c, process)});
    } else if (known->direction != port.direction) {
        c.reporter.error(port.at,
                         fmt::format("the channel \"{}\" of the kind \"{}\" is an {}, not an {}", port.name, kind.name,
                                     word(known->direction), word(port.direction)),
                         "", {used_here(c, process)});
    }
}

const char* word(ParameterType type) {
    return type == ParameterType::integer ? "an integer (int)"
           : type == ParameterType::real  ? "real (double)"
                                          : "text (char [])";
}

void check_parameter(Completion& c, const DraftProcess& process, const ParameterDeclaration& parameter,
                     const ProcessKind& kind) {
    const auto* known = kind.parameter(parameter.name);
    std::vector<SecondPlace> others{used_here(c, process)};
    if (known == nullptr) {
        c.reporter.error(parameter.at,
                         fmt::format("the kind \"{}\" has no parameter \"{}\"", kind.name, parameter.name),
                         did_you_mean(parameter.name, names_in(kind.parameters)), std::move(others));
    } else if (known->type != element_type(parameter) || element_dimensions(parameter) != 0) {
        c.reporter.error(
            parameter.at,
            fmt::format("the parameter \"{}\" of the kind \"{}\" is {}", parameter.name, kind.name, word(known->type)),
            "", std::move(others));
    }
}

void refuse_left_out(Completion& c, const DraftProcess& process, const PortDescription& needed,
                     const ProcessKind& kind) {
    c.reporter.error(process.declared,
                     fmt::format("the channel \"{}\" of the kind \"{}\" is missing in the interface of \"{}\"",
                                 needed.name, kind.name, process.name),
                     fmt::format("interface ({} {}, ...)", word(needed.direction), needed.name),
                     {used_here(c, process)});
}

/// What the netlist's interface says must be in the kind, and the ports that the kind cannot do without must
/// be in the interface.
void check_interface(Completion& c, const DraftProcess& process, const ProcessKind& kind) {
    const auto& interface = *process.interface;
    for (const auto& port : interface.ports)
        check_port(c, process, port, kind);
    for (const auto& parameter : interface.parameters)
        check_parameter(c, process, parameter, kind);
    for (const auto& needed : kind.ports)
        if (!needed.optional &&
            std::ranges::find(interface.ports, needed.name, &PortDeclaration::name) == interface.ports.end())
            refuse_left_out(c, process, needed, kind);
}

void take_over(ProcessInstance& process, const DraftProcess& draft) {
    process.name = draft.name;
    process.kind = draft.kind;
    process.high_priority = draft.high_priority;
    if (draft.interface) // shares ownership of the whole
        process.interface = {draft.interface, &draft.interface->entries};
    process.node = draft.node;
    process.other = draft.other;
    process.declared = draft.declared;
}

void complete_process(Completion& c, std::size_t index) {
    const auto* kind = c.kinds[index] = find_kind(c, index);
    const auto& draft = c.draft.processes[index];
    if (draft.node == nowhere)
        c.reporter.error(draft.declared, fmt::format("the process \"{}\" is placed on no processor", draft.name),
                         fmt::format("place {} on ...;", draft.name));
    if (kind != nullptr && draft.interface)
        check_interface(c, draft, *kind);
    if (!c.kind_refused[index])
        complete_parameters(c, index);
    take_over(c.network.processes[index], draft);
    c.network.processes[index].stand_in = kind == nullptr;
}

} // namespace

void complete_processes(Completion& c) {
    const auto count = c.draft.processes.size();
    c.kinds.assign(count, nullptr);
    c.kind_refused.assign(count, false);
    c.network.processes.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        complete_process(c, i);
}

} // namespace placedpar
