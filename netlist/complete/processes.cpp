#include "netlist/complete/complete.hpp"
#include "netlist/elaborate/declared_type.hpp"
#include "netlist/network/names.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

bool is_one_of(std::string_view set, char c) { return set.find(c) != set.npos; }

/// Returns true for names of program files of the INMOS toolset: "farm.lku", "FARM.C8H", "farm.lah", "farm.tco",
/// "farm.c0", and "farm" without an ending.
bool is_program_file(std::string_view name) {
    auto dot = name.rfind('.');
    if (dot == std::string_view::npos)
        return true;
    auto ending = lower_case(name.substr(dot + 1));
    if (ending == "lku" || ending == "lkd" || ending == "tco" || ending == "rsc" || ending == "btl")
        return true;
    bool is_of_target = ending.size() >= 2 && is_one_of("clt", ending[0]) && is_one_of("0123456789abce", ending[1]);
    return is_of_target && (ending.size() == 2 || (ending.size() == 3 && is_one_of("hsxu", ending[2])));
}

const ProcessKind* find_kind(Completion& c, std::size_t index) {
    auto& process = c.draft.processes[index];
    auto used = process.used.value_or(c.draft.default_used);
    const auto* kind = c.catalogue.find(process.kind);
    if (kind != nullptr || process.kind.empty())
        return kind;
    auto guess = did_you_mean(process.kind, c.catalogue.kind_names());
    if (is_program_file(process.kind) && (guess.empty() || process.kind.find('.') != std::string::npos))
        return nullptr;
    c.kind_refused[index] = true;
    c.reporter.error(
        used, fmt::format("unknown process kind \"{}\"", process.kind),
        guess.empty()
            ? "the command \"kinds\" lists all kinds; the name of a program file ends in .lku, .c8h or the like"
            : guess);
    return nullptr;
}

SecondPlace used_here(const Completion& c, const DraftProcess& process) {
    return {"the kind is used here", process.used.value_or(c.draft.default_used)};
}

void check_port(Completion& c, const DraftProcess& process, const PortDeclaration& port, const ProcessKind& kind) {
    const auto* known = kind.port(port.name);
    if (known == nullptr) {
        c.reporter.error(port.at, fmt::format("the kind \"{}\" has no channel \"{}\"", kind.name, port.name),
                         kind.hint_at_port(port.name), {used_here(c, process)});
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
        c.reporter.error(parameter.at,
                         fmt::format("the parameter \"{}\" of the kind \"{}\" is {}, but has another type here",
                                     parameter.name, kind.name, word(known->type)),
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

/// Checks the interface in the netlist against the kind. The kind must have each entry of the interface, and the
/// interface must have each port that the kind requires.
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

/// Reports a process that is placed on a switch, if it is not of the kind that obeys the switch's commands.
void check_logic(Completion& c, const DraftProcess& process) {
    const Node& node = c.network.nodes[process.node];
    if (node.kind->is_set_by_link() && process.kind != node.kind->logic)
        c.reporter.error(process.placed,
                         fmt::format("\"{}\" is {}: only a process that is its logic can be placed on it", node.name,
                                     node.kind->noun),
                         fmt::format("use \"{}\" for {};", node.kind->logic, process.name));
}

void take_over(ProcessInstance& process, const DraftProcess& draft) {
    process.name = draft.name;
    process.kind = draft.kind;
    process.high_priority = draft.high_priority;
    if (draft.interface) // the aliasing pointer shares ownership of the interface
        process.interface = {draft.interface, &draft.interface->entries};
    process.node = draft.node;
    process.other = draft.other;
    process.declared = draft.declared;
}

void complete_process(Completion& c, std::size_t index) {
    const auto* kind = c.kinds[index] = find_kind(c, index);
    const auto& draft = c.draft.processes[index];
    if (draft.node == nowhere)
        c.reporter.error(draft.declared, fmt::format("the process \"{}\" is not placed on a processor", draft.name),
                         fmt::format("place {} on ...;", draft.name));
    else
        check_logic(c, draft);
    if (kind != nullptr && draft.interface)
        check_interface(c, draft, *kind);
    if (!c.kind_refused[index])
        complete_parameters(c, index);
    take_over(c.network.processes[index], draft);
    c.network.processes[index].stand_in = kind == nullptr;
    if (kind != nullptr && kind->is_code) {
        c.network.processes[index].is_code = true;
        c.network.processes[index].program_hash = kind->text_hash;
    }
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
