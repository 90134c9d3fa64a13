#include "hydraulics/data/parameters.hpp"

#include "hydraulics/data/parameter_range.hpp"
#include "hydraulics/data/units.hpp"
#include "text/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace placedpar::hydraulics {

namespace {

constexpr std::array<std::string_view, 5> columns{"name", "value", "unit", "mark", "source"};
constexpr std::array<std::string_view, 4> marks{"thesis", "fitted", "ours", "measured"};

struct NamedCells {
    const TextCell &name, &value, &unit, &mark, &source;
};

NamedCells named_cells(const TextRow& row) {
    return {row.cells[0], row.cells[1], row.cells[2], row.cells[3], row.cells[4]};
}

bool header_is_right(const TextRow& header) { return std::ranges::equal(header.cells, columns, {}, &TextCell::text); }

void refuse(std::vector<Diagnostic>& faults, std::size_t line, const TextCell& cell, std::string message,
            std::string hint) {
    faults.push_back(error_at(line, cell.column, std::move(message), std::move(hint)));
}

std::vector<Parameter> parameters_of(std::string_view text) {
    std::vector<Diagnostic> faults;
    TextTable table = split_table(text, faults);
    std::vector<Parameter> parameters;
    for (const TextRow& row : table.rows) {
        NamedCells cells = named_cells(row);
        const Unit* unit = unit_named(cells.unit.text);
        if (!unit || unit->factor != 1)
            throw std::logic_error(
                fmt::format("excavator.csv:{}: expected a unit whose factor in units.hpp is 1", row.line));
        parameters.push_back({cells.name.text, number_in(cells.value, row.line, faults), cells.unit.text,
                              cells.mark.text, cells.source.text});
    }
    if (!faults.empty() || !header_is_right(table.header))
        throw std::logic_error("excavator.csv is not a table of parameters");
    return parameters;
}

} // namespace

UnknownParameter::UnknownParameter(std::string_view name)
    : std::invalid_argument(fmt::format("the machine has no parameter {}", name)) {}

const Parameters& Parameters::excavator() {
    static const Parameters parameters = [] {
        Parameters read;
        read.parameters_ = parameters_of(excavator_text());
        return read;
    }();
    return parameters;
}

const Parameter* Parameters::find(std::string_view name) const {
    auto found = std::ranges::find(parameters_, name, &Parameter::name);
    return found == parameters_.end() ? nullptr : &*found;
}

Parameter& Parameters::entry(std::string_view name) {
    auto found = std::ranges::find(parameters_, name, &Parameter::name);
    if (found == parameters_.end())
        throw UnknownParameter(name);
    return *found;
}

double Parameters::operator[](std::string_view name) const {
    if (const Parameter* parameter = find(name))
        return parameter->value;
    throw UnknownParameter(name);
}

void Parameters::set(std::string_view name, double value) { entry(name).value = value; }

void Parameters::put(Parameter parameter) { entry(parameter.name) = std::move(parameter); }

void Parameters::read(std::string_view text, std::vector<Diagnostic>& faults) {
    TextTable table = split_table(text, faults);
    if (!header_is_right(table.header)) {
        faults.push_back(error_at(table.header.line, table.header.cells.empty() ? 0u : 1u,
                                  "this is not the header of a table of parameters",
                                  "write the header name,value,unit,mark,source"));
        return;
    }
    for (const TextRow& row : table.rows)
        read_row(row, faults);
}

void Parameters::read_row(const TextRow& row, std::vector<Diagnostic>& faults) {
    const auto& [name, number, unit_name, mark, source] = named_cells(row);
    if (!find(name.text)) {
        refuse(faults, row.line, name, fmt::format("the machine has no parameter \"{}\"", name.text),
               "placedpar parameters lists all parameters");
        return;
    }
    Parameter& parameter = entry(name.text);
    Quantity quantity = unit_named(parameter.unit)->quantity;
    const Unit* unit = unit_named(unit_name.text);
    std::size_t before = faults.size();
    double value = number_in(number, row.line, faults);
    bool is_number = faults.size() == before;
    if (!unit || unit->quantity != quantity)
        refuse(faults, row.line, unit_name,
               fmt::format("\"{}\" is not a unit of {}", unit_name.text, name_of(quantity)), list_units(quantity));
    else if (std::ranges::find(marks, mark.text) == marks.end())
        refuse(faults, row.line, mark, fmt::format("\"{}\" is not a mark", mark.text),
               "write thesis, fitted, ours or measured");
    else if (ParameterRange range = range_of(parameter.name); is_number && !range.contains(value * unit->factor))
        refuse(faults, row.line, number, fmt::format("{} cannot be {}", parameter.name, number.text), range.expected());
    else
        parameter = {parameter.name, value * unit->factor, parameter.unit, mark.text, source.text};
}

} // namespace placedpar::hydraulics
