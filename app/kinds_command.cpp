#include "app/kinds_command.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "text/standard_output.hpp"
#include "workbench/problems.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <stdexcept>
#include <string>

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
    switch (type) {
    case ParameterType::integer: return "int";
    case ParameterType::real: return "double";
    case ParameterType::text: return "string";
    }
    return "";
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

std::string print_kinds() {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    std::string out;
    for (const auto& [name, kind] : catalogue.kinds())
        out += fmt::format("{:<16} {}\n", name, kind.about);
    return out + "\nsay placedpar kinds NAME for ports, parameters and measures\n";
}

std::string print_kind(const std::string& name) {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    const ProcessKind* kind = catalogue.find(name);
    if (!kind)
        throw std::runtime_error(
            fmt::format("there is no process kind \"{}\"; say placedpar kinds for those there are", name));
    std::string out = fmt::format("{}\n{}\n\nports\n", kind->name, kind->about);
    for (const PortDescription& port : kind->ports)
        out += fmt::format("  {:<14} {:<7} {:<14} {}{}\n", port.name,
                           port.direction == Direction::input ? "input" : "output", port.protocol, port.about,
                           port.optional ? " (may stay unconnected)" : "");
    if (!kind->parameters.empty())
        out += print_parameters(*kind);
    if (!kind->measurements.empty())
        out += "\nmeasures\n";
    for (const MeasurementDescription& measure : kind->measurements)
        out += fmt::format("  {:<28} {:<7} {}\n", measure.name, measure.unit, measure.about);
    return out;
}

} // namespace

void declare_kinds(CLI::App& app, ChosenCommand& chosen) {
    auto name = std::make_shared<std::string>();
    auto* command = app.add_subcommand("kinds", "Lists the process kinds that a netlist can use");
    command->add_option("NAME", *name, "everything about this kind");
    command->callback([&chosen, name] {
        chosen = [name] {
            print_out(name->empty() ? print_kinds() : print_kind(*name));
            return ExitCode::success;
        };
    });
}

} // namespace placedpar
