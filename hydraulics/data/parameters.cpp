#include "hydraulics/data/parameters.hpp"

#include "hydraulics/data/parameter_range.hpp"
#include "hydraulics/data/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace placedpar::hydraulics {

namespace {

constexpr std::array<std::string_view, 5> columns{"name", "value", "unit", "mark", "source"};
constexpr std::array<std::string_view, 4> marks{"thesis", "fitted", "ours", "measured"};

bool header_is_right(const TextRow& header) { return std::ranges::equal(header.cells, columns, {}, &TextCell::text); }

void refuse(std::vector<TextFault>& faults, std::size_t line, const TextCell& cell, std::string message,
            std::string hint) {
    faults.push_back({true, line, cell.column, std::move(message), std::move(hint)});
}

/// Reads the text that defines which parameters there are.
std::vector<Parameter> parameters_of(std::string_view text) {
    std::vector<TextFault> faults;
    TextTable table = split_table(text, faults);
    std::vector<Parameter> parameters;
    for (const TextRow& row : table.rows) {
        const Unit* unit = unit_named(row.cells[2].text);
        if (!unit || unit->factor != 1)
            throw std::logic_error(fmt::format("excavator.csv:{}: not a unit of this room", row.line));
        parameters.push_back({row.cells[0].text, number_in(row.cells[1], row.line, faults), row.cells[2].text,
                              row.cells[3].text, row.cells[4].text});
    }
    if (!faults.empty() || !header_is_right(table.header))
        throw std::logic_error("excavator.csv is not a table of parameters");
    return parameters;
}

} // namespace

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

Parameter* Parameters::entry(std::string_view name) {
    return const_cast<Parameter*>(static_cast<const Parameters&>(*this).find(name));
}

double Parameters::operator[](std::string_view name) const {
    if (const Parameter* parameter = find(name))
        return parameter->value;
    throw std::invalid_argument(fmt::format("the machine has no parameter {}", name));
}

void Parameters::set(std::string_view name, double value) {
    Parameter* parameter = entry(name);
    if (!parameter)
        throw std::invalid_argument(fmt::format("the machine has no parameter {}", name));
    parameter->value = value;
}

void Parameters::put(Parameter parameter) {
    Parameter* place = entry(parameter.name);
    if (!place)
        throw std::invalid_argument(fmt::format("the machine has no parameter {}", parameter.name));
    *place = std::move(parameter);
}

void Parameters::read(std::string_view text, std::vector<TextFault>& faults) {
    TextTable table = split_table(text, faults);
    if (!header_is_right(table.header)) {
        faults.push_back({true, table.header.line, table.header.cells.empty() ? 0u : 1u,
                          "not the header of a table of parameters", "name,value,unit,mark,source"});
        return;
    }
    for (const TextRow& row : table.rows)
        read_row(row, faults);
}

void Parameters::read_row(const TextRow& row, std::vector<TextFault>& faults) {
    Parameter* parameter = entry(row.cells[0].text);
    if (!parameter) {
        refuse(faults, row.line, row.cells[0], fmt::format("the machine has no parameter \"{}\"", row.cells[0].text),
               "placedpar parameters lists them");
        return;
    }
    Quantity quantity = unit_named(parameter->unit)->quantity;
    const Unit* unit = unit_named(row.cells[2].text);
    std::size_t before = faults.size();
    double value = number_in(row.cells[1], row.line, faults);
    bool is_number = faults.size() == before;
    if (!unit || unit->quantity != quantity)
        refuse(faults, row.line, row.cells[2],
               fmt::format("\"{}\" is not a unit of {}", row.cells[2].text, name_of(quantity)), list_units(quantity));
    else if (std::ranges::find(marks, row.cells[3].text) == marks.end())
        refuse(faults, row.line, row.cells[3], fmt::format("\"{}\" is not a mark", row.cells[3].text),
               "thesis, fitted, ours or measured");
    else if (ParameterRange range = range_of(parameter->name); is_number && !range.contains(value * unit->factor))
        refuse(faults, row.line, row.cells[1], fmt::format("{} cannot be {}", parameter->name, row.cells[1].text),
               range.expected());
    else {
        parameter->value = value * unit->factor;
        parameter->mark = row.cells[3].text;
        parameter->source = row.cells[4].text;
    }
}

} // namespace placedpar::hydraulics
