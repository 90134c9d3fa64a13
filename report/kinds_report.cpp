#include "report/kinds_report.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "report/kinds_choice.hpp"
#include "text/paint.hpp"

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

std::string print_parameters(const ProcessKind& kind) {
    std::string out = painted(Paint::heading, "\nparameters\n");
    for (const ParameterDescription& parameter : kind.parameters)
        out += print_parameter(parameter, parameter.default_value);
    return out;
}

std::string print_ports(const ProcessKind& kind) {
    std::string out = painted(Paint::heading, "\nports\n");
    for (const PortDescription& port : kind.ports)
        out += fmt::format("  {:<14} {:<7} {:<14} {}{}\n", port.name,
                           port.direction == Direction::input ? "input" : "output", port.protocol, port.about,
                           port.optional ? " (may stay unconnected)" : "");
    return out;
}

std::string print_measures(const ProcessKind& kind) {
    std::string out = painted(Paint::heading, "\nmeasures\n");
    for (const MeasurementDescription& measure : kind.measurements)
        out += fmt::format("  {:<28} {:<7} {}\n", measure.name, measure.unit, measure.about);
    return out;
}

std::string print_process(const ProcessKind& kind) {
    return fmt::format("{}\n{}\n", painted(Paint::heading, kind.name), kind.about) + print_ports(kind) +
           (kind.parameters.empty() ? "" : print_parameters(kind)) +
           (kind.measurements.empty() ? "" : print_measures(kind));
}

/// Returns whether the model is only another spelling, such as t800 for T800.
bool is_alias(const DeviceModel& model) {
    auto upper = [](unsigned char c) { return std::toupper(c); };
    return model.name != model.type && std::ranges::equal(model.name, model.type, {}, upper, upper);
}

/// Returns whether the model is a module with another transputer than the usual transputer, such as B403_T414.
bool is_variant(const DeviceModel& model) { return model.name.find('_') != std::string::npos; }

/// Returns the names of the kind's models, without aliases, variants and the model that stands for all models.
std::vector<std::string> model_names(const DeviceKind& kind) {
    std::vector<std::string> names;
    for (const DeviceModel& model : kind.models)
        if (!model.needs_type && !is_alias(model) && !is_variant(model))
            names.push_back(model.name);
    return names;
}

std::string print_line(const std::string& name, const std::string& about) {
    return fmt::format("  {:<16} {}\n", name, about);
}

/// Prints the kind under the name of its only model, or under its own name with the models on the next line.
std::string print_device_lines(const DeviceKind& kind) {
    auto names = model_names(kind);
    std::string about = kind.about + (kind.refusal.empty() ? "" : " Cannot be declared yet.");
    if (names.size() == 1)
        return print_line(names.front(), about);
    return print_line(kind.name, about) + print_line("", fmt::format("{}", fmt::join(names, " ")));
}

std::string print_process_lines(const std::vector<const ProcessKind*>& kinds) {
    std::string out;
    for (const ProcessKind* kind : kinds)
        out += print_line(kind->name, kind->about);
    return out;
}

std::string print_devices(const Catalogue& catalogue) {
    std::string out = painted(Paint::heading, "devices\n");
    for (const auto& [name, kind] : catalogue.devices())
        out += print_device_lines(*kind);
    return out;
}

const char* moment_of_acknowledge(const NodeType& type) {
    return type.preset.overlapped_acknowledge ? "; each byte is acknowledged while it arrives"
                                              : "; each byte is acknowledged when it has arrived";
}

std::string print_link_count(const NodeType& type) {
    if (type.links == 0 || type.needs_type)
        return "";
    bool acknowledges = type.preset.kind->links == LinkRole::ends;
    return fmt::format("links: {}{}\n", type.links, acknowledges ? moment_of_acknowledge(type) : "");
}

std::string print_needed_type(const DeviceKind& kind) {
    return fmt::format("  {:<28} string  must be given: one of\n  {:<28} {}\n", "type", "",
                       fmt::join(model_names(kind), " "));
}

std::string print_kept(const DeviceKind& kind) {
    return fmt::format("  {}\n  {:<28} read and printed, without effect on a run\n", fmt::join(kind.kept, ", "), "");
}

/// Prints the attributes with the type's defaults, which include the model's defaults.
std::string print_attributes(const NodeType& type) {
    const DeviceKind& kind = *type.preset.kind;
    std::string out = painted(Paint::heading, "\nattributes\n") + (type.needs_type ? print_needed_type(kind) : "");
    for (const AttributeDescription& attribute : kind.attributes)
        out += print_parameter(attribute.value, type.preset.attributes.find(attribute.value.name)->second);
    return kind.kept.empty() ? out : out + print_kept(kind);
}

std::string print_fault_kinds(const char* heading, const std::vector<FaultKind>& kinds) {
    std::string out = kinds.empty() ? "" : painted(Paint::heading, fmt::format("\n{}\n", heading));
    for (const FaultKind& kind : kinds) {
        out += fmt::format("  {}: {}\n", kind.name, kind.about);
        for (const AttributeDescription& attribute : kind.attributes)
            out += print_parameter(attribute.value, attribute.value.default_value);
    }
    return out;
}

/// Prints the faults that a `fault` statement can state for a node and for its links.
std::string print_fault_kinds(const DeviceKind& kind) {
    bool has_links = kind.links == LinkRole::ends && !kind.medium;
    return print_fault_kinds("faults", kind.faults) +
           (has_links ? print_fault_kinds("faults of its links", link_faults()) : "");
}

/// Returns "B404 (T800)" for a module, with the transputer that it carries; otherwise the name.
std::string print_name(const std::string& name, const NodeType& type) {
    bool carries = !type.needs_type && type.preset.type != name;
    return carries ? fmt::format("{} ({})", name, type.preset.type) : name;
}

std::string print_what_is_placed(const DeviceKind& kind) {
    if (kind.is_set_by_link())
        return fmt::format("a {}, which the link config sets during the run", kind.logic);
    return kind.executes != Execution::none ? "can be placed on it" : "none can be placed on it";
}

/// Prints the device type of this name.
std::string print_device(const std::string& name, const NodeType& type) {
    const DeviceKind& kind = *type.preset.kind;
    std::string head = fmt::format("{}\n{}\n", painted(Paint::heading, print_name(name, type)), kind.about);
    if (!kind.refusal.empty())
        return head + fmt::format("cannot be declared: {}\n", kind.refusal);
    return head + print_link_count(type) + fmt::format("processes: {}\n", print_what_is_placed(kind)) +
           (kind.has_attributes() ? print_attributes(type) : "") + print_fault_kinds(kind);
}

} // namespace

std::string print_parameter(const ParameterDescription& p, const std::optional<Value>& by_default) {
    return fmt::format("  {:<28} {:<7} default {:<14} {:<28} {}\n", p.name, word(p.type),
                       by_default ? print_value(*by_default) : "none", print_range(p), p.unit) +
           fmt::format("  {:<28} {}\n", "", p.about);
}

std::string print_kinds(const Catalogue& catalogue) {
    return painted(Paint::heading, "processes\n") + print_process_lines(group_of(catalogue, processes_group)) + "\n" +
           print_devices(catalogue);
}

std::string print_kind(const Catalogue& catalogue, const std::string& name) {
    if (const ProcessKind* kind = catalogue.find(name))
        return print_process(*kind);
    if (auto type = catalogue.node_types().find(name); type != catalogue.node_types().end())
        return print_device(name, type->second);
    if (auto group = group_of(catalogue, name); !group.empty())
        return painted(Paint::heading, name + "\n") + print_process_lines(group);
    if (name == devices_group)
        return print_devices(catalogue);
    refuse_kind(catalogue, name);
}

} // namespace placedpar
