#include "app/record/scenario_record.hpp"
#include "text/program_name.hpp"

#include "hydraulics/data/parameter_range.hpp"
#include "hydraulics/data/units.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

[[noreturn]] void refuse(const Parameter& parameter, const std::string& text, const std::string& why) {
    throw UserError(fmt::format("--set {}={}: {}", parameter.name, text, why));
}

/// Reads a number and an optional unit after it.
double number_of(const Parameter& parameter, const std::string& text) {
    double number = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number))
        refuse(
            parameter, text,
            fmt::format("expected a number; its default unit is {}", parameter.unit.empty() ? "none" : parameter.unit));
    std::string_view rest(end, text.data() + text.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (rest.empty())
        return number;
    Quantity quantity = unit_named(parameter.unit)->quantity;
    const Unit* unit = unit_named(rest);
    if (!unit || unit->quantity != quantity)
        refuse(parameter, text,
               quantity == Quantity::number ? std::string("this parameter has no unit; leave the unit out")
                                            : fmt::format("\"{}\" is not a unit of {}; expected {}", rest,
                                                          name_of(quantity), list_units(quantity)));
    return number * unit->factor;
}

double value_of(const Parameter& parameter, const std::string& text) {
    double value = number_of(parameter, text);
    if (ParameterRange range = range_of(parameter.name); !range.contains(value))
        refuse(parameter, text, fmt::format("expected {}", range.expected()));
    return value;
}

const Parameter& parameter_called(const RecordScenario& scenario, const Parameters& parameters,
                                  const std::string& name) {
    const Parameter* parameter = parameters.find(name);
    if (parameter && scenario.uses(name))
        return *parameter;
    std::vector<std::string> names;
    for (const Parameter& each : parameters.all())
        if (scenario.uses(each.name))
            names.push_back(each.name);
    std::string nearest = did_you_mean(name, names);
    throw UserError(fmt::format(
        "--set {}: the scenario {} has no such parameter; {}", name, scenario.name,
        nearest.empty() ? fmt::format("{} record {} --list shows its parameters", program_name(), scenario.name)
                        : nearest));
}

/// Puts the text in quotes if it contains a separator of cells.
std::string cell(const std::string& text) {
    return text.find_first_of(",\"") == std::string::npos ? text : fmt::format("\"{}\"", text);
}

} // namespace

std::vector<std::string> names_of_scenarios() {
    std::vector<std::string> names;
    for (const RecordScenario& scenario : record_scenarios())
        names.emplace_back(scenario.name);
    return names;
}

const RecordScenario& scenario_called(std::string_view name) {
    if (const RecordScenario* scenario = record_scenario_named(name))
        return *scenario;
    std::string names;
    std::span<const RecordScenario> all = record_scenarios();
    for (const RecordScenario& scenario : all) {
        names += fmt::format("{}{}",
                             &scenario == &all.front()  ? ""
                             : &scenario == &all.back() ? " and "
                                                        : ", ",
                             scenario.name);
    }
    throw UserError(unknown_name("scenario", name, names_of_scenarios(), "the scenarios are " + names));
}

Parameters scenario_parameters(const RecordScenario& scenario, const Parameters& machine, const std::string& noise,
                               const Overrides& overrides) {
    Parameters parameters = scenario.parameters(machine);
    if (!noise.empty()) {
        std::vector<Parameter> rows = noise_rows(machine, noise);
        if (rows.empty())
            throw UserError(fmt::format("--noise {}: expected none, low, mid or high", noise));
        for (Parameter& row : rows)
            parameters.put(std::move(row));
    }
    for (const auto& [name, text] : overrides)
        parameters.set(name, value_of(parameter_called(scenario, parameters, name), text));
    return parameters;
}

std::string list_parameters(const RecordScenario& scenario, const Parameters& parameters) {
    std::string text = "name,value,unit,mark,source\n";
    for (const Parameter& parameter : parameters.all())
        if (scenario.uses(parameter.name))
            text += fmt::format("{},{},{},{},{}\n", parameter.name, parameter.value, cell(parameter.unit),
                                parameter.mark, cell(parameter.source));
    return text;
}

std::string list_record_scenarios() {
    std::string text;
    for (const RecordScenario& scenario : record_scenarios())
        text += fmt::format("  {:<12} {}\n", scenario.name, scenario.about);
    return text;
}

} // namespace placedpar
