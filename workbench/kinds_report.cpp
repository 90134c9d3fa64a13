#include "workbench/kinds_report.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

namespace placedpar {

namespace {

std::string print_value(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        return "\"" + *text + "\"";
    if (const auto* number = std::get_if<double>(&value))
        return fmt::format("{}", *number);
    return fmt::format("{}", std::get<std::int64_t>(value));
}

std::string print_range(const ParameterDescription& parameter) {
    if (!parameter.choices.empty())
        return fmt::format("{}", fmt::join(parameter.choices, " | "));
    if (parameter.type == ParameterType::text)
        return "text";
    std::string least = parameter.least ? fmt::format("{}", *parameter.least) : "";
    std::string most = parameter.most ? fmt::format("{}", *parameter.most) : "";
    return least + " .. " + most;
}

const char* type_name(ParameterType type) {
    return type == ParameterType::integer ? "int" : type == ParameterType::real ? "double" : "string";
}

std::string print_parameter(const ParameterDescription& p, const std::optional<Value>& by_default) {
    return fmt::format("  {:<28} {:<7} default {:<14} {:<28} {}\n", p.name, type_name(p.type),
                       by_default ? print_value(*by_default) : "none", print_range(p), p.unit) +
           fmt::format("  {:<28} {}\n", "", p.about);
}

std::string print_parameters(const ProcessKind& kind) {
    std::string out = "\nparameters\n";
    for (const ParameterDescription& parameter : kind.parameters)
        out += print_parameter(parameter, parameter.default_value);
    return out;
}

std::string print_ports(const ProcessKind& kind) {
    std::string out = "\nports\n";
    for (const PortDescription& port : kind.ports)
        out += fmt::format("  {:<14} {:<7} {:<14} {}{}\n", port.name,
                           port.direction == Direction::input ? "input" : "output", port.protocol, port.about,
                           port.optional ? " (may stay unconnected)" : "");
    return out;
}

std::string print_measures(const ProcessKind& kind) {
    std::string out = "\nmeasures\n";
    for (const MeasurementDescription& measure : kind.measurements)
        out += fmt::format("  {:<28} {:<7} {}\n", measure.name, measure.unit, measure.about);
    return out;
}

std::string print_process(const ProcessKind& kind) {
    return fmt::format("{}\n{}\n", kind.name, kind.about) + print_ports(kind) +
           (kind.parameters.empty() ? "" : print_parameters(kind)) +
           (kind.measurements.empty() ? "" : print_measures(kind));
}

bool in_other_letters(const std::string& one, const std::string& other) {
    auto upper = [](unsigned char c) { return std::toupper(c); };
    return one != other && std::ranges::equal(one, other, {}, upper, upper);
}

/// What nodes of the kind are declared by, but for what stands for all of them, and for T800 written t800.
std::vector<std::string> model_names(const DeviceKind& kind) {
    std::vector<std::string> names;
    for (const DeviceModel& model : kind.models)
        if (!model.needs_type && !in_other_letters(model.name, model.type))
            names.push_back(model.name);
    return names;
}

/// The kind by its only model, or by its own name with the models below.
std::string print_line(const DeviceKind& kind) {
    auto names = model_names(kind);
    std::string out = fmt::format("  {:<16} {}\n", names.size() == 1 ? names.front() : kind.name, kind.about);
    if (names.size() > 1)
        out += fmt::format("  {:<16} {}\n", "", fmt::join(names, " "));
    return out;
}

std::string print_links(const NodeType& type) {
    const DeviceKind& kind = *type.preset.kind;
    if (kind.links == LinkRole::ends && type.links > 0)
        return fmt::format("links: {}; a byte is acknowledged {}\n", type.links,
                           type.preset.overlapped_acknowledge ? "while it comes in" : "when it has come in");
    return kind.links == LinkRole::crosses ? fmt::format("links: {}\n", type.links) : "";
}

std::string print_attributes(const NodeType& type) {
    const DeviceKind& kind = *type.preset.kind;
    std::string out = kind.has_attributes() ? "\nattributes\n" : "";
    if (type.needs_type)
        out += fmt::format("  {:<28} string  must be given: one of\n  {:<28} {}\n", "type", "",
                           fmt::join(model_names(kind), " "));
    for (const AttributeDescription& attribute : kind.attributes)
        out += print_parameter(attribute.value, type.preset.attributes.find(attribute.value.name)->second);
    if (!kind.kept.empty())
        out +=
            fmt::format("  {}\n  {:<28} read and printed, without effect on a run\n", fmt::join(kind.kept, ", "), "");
    return out;
}

/// What nodes can be declared with by this name. What the model says itself takes the place of the kind's default.
std::string print_device(const std::string& name, const NodeType& type) {
    const DeviceKind& kind = *type.preset.kind;
    std::string carries = type.needs_type || type.preset.type == name ? "" : fmt::format(" ({})", type.preset.type);
    if (!kind.refusal.empty())
        return fmt::format("{}\n{}\ncannot be declared: {}\n", name, kind.about, kind.refusal);
    return fmt::format("{}{}\n{}\n{}processes: {}\n", name, carries, kind.about, print_links(type),
                       kind.runs_processes ? "can be placed on it" : "none can be placed on it") +
           print_attributes(type);
}

} // namespace

std::string print_kinds(const Catalogue& catalogue) {
    std::string out = "processes\n";
    for (const auto& [name, kind] : catalogue.kinds())
        out += fmt::format("  {:<16} {}\n", name, kind.about);
    out += "\ndevices\n";
    for (const auto& [name, kind] : catalogue.devices())
        out += print_line(*kind);
    return out;
}

std::string print_kind(const Catalogue& catalogue, const std::string& name) {
    if (const ProcessKind* kind = catalogue.find(name))
        return print_process(*kind);
    if (auto type = catalogue.node_types().find(name); type != catalogue.node_types().end())
        return print_device(name, type->second);
    throw UserError(
        fmt::format("there is no process kind and no device \"{}\"; say placedpar kinds for those there are", name));
}

} // namespace placedpar
