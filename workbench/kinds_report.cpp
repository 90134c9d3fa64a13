#include "workbench/kinds_report.hpp"

#include "netlist/kinds/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::string print_parameters(const ProcessKind& kind) {
    std::string out = "\nparameters\n";
    for (const ParameterDescription& p : kind.parameters) {
        out += fmt::format("  {:<28} {:<7} default {:<14} {:<28} {}\n", p.name, type_name(p.type),
                           p.default_value ? print_value(*p.default_value) : "none", print_range(p), p.unit);
        out += fmt::format("  {:<28} {}\n", "", p.about);
    }
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

} // namespace

std::string print_kinds(const Catalogue& catalogue) {
    std::string out;
    for (const auto& [name, kind] : catalogue.kinds())
        out += fmt::format("{:<16} {}\n", name, kind.about);
    return out;
}

std::string print_kind(const ProcessKind& kind) {
    return fmt::format("{}\n{}\n", kind.name, kind.about) + print_ports(kind) +
           (kind.parameters.empty() ? "" : print_parameters(kind)) +
           (kind.measurements.empty() ? "" : print_measures(kind));
}

} // namespace placedpar
