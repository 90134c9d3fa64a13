#include "hydraulics/data/record_table.hpp"

#include "hydraulics/data/record_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

/// What a column of the file holds.
struct Column {
    std::size_t index;
    std::size_t at; ///< column of its name in the header's line
    std::string name;
    const Unit* unit;
    std::vector<double>* values;  ///< in the record
    std::optional<Sensor> sensor; ///< none: the time
};

/// "boom.spool [in]" in its two parts; the unit is empty where there are no brackets.
std::pair<std::string, std::string> name_and_unit(const std::string& header) {
    std::size_t open = header.find('[');
    if (open == std::string::npos || header.back() != ']')
        return {header, ""};
    std::string name = header.substr(0, open);
    name.erase(name.find_last_not_of(" \t") + 1);
    return {name, header.substr(open + 1, header.size() - open - 2)};
}

/// Where a column's values go and what they measure; no values when there is no such column.
struct Destination {
    std::vector<double>* values = nullptr;
    std::optional<Sensor> sensor = std::nullopt;

    Quantity quantity() const { return sensor ? quantity_of(*sensor) : Quantity::time; }
};

Destination destination_of(const std::string& name, Record& record) {
    if (name == "time")
        return {&record.time_s};
    std::size_t dot = name.find('.');
    auto link = link_named(name.substr(0, dot));
    auto sensor = dot == std::string::npos ? std::nullopt : sensor_named(std::string_view(name).substr(dot + 1));
    if (!link || !sensor)
        return {};
    return {&record.of(*link, *sensor), sensor};
}

std::vector<Column> read_header(const TextRow& header, Record& record, std::vector<Diagnostic>& faults) {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
        const TextCell& cell = header.cells[i];
        auto [name, unit_name] = name_and_unit(cell.text);
        auto refuse = [&](std::string message, std::string hint) {
            faults.push_back(error_at(header.line, cell.column, std::move(message), std::move(hint)));
        };
        Destination destination = destination_of(name, record);
        const Unit* unit = unit_named(unit_name);
        if (!destination.values)
            faults.push_back(
                warning_at(header.line, cell.column, fmt::format("column \"{}\" is not used", name),
                           "columns are time and LINK.SENSOR, such as boom.inlet_pressure or bucket.angle"));
        else if (!unit || unit->quantity != destination.quantity())
            refuse(unit_name.empty()
                       ? fmt::format("column \"{}\" has no unit", name)
                       : fmt::format("\"{}\" is not a unit of {}", unit_name, name_of(destination.quantity())),
                   fmt::format("{} [UNIT] with {}", name, list_units(destination.quantity())));
        else if (auto before = std::ranges::find(columns, destination.values, &Column::values); before != columns.end())
            refuse(fmt::format("column \"{}\" is there twice", name),
                   fmt::format("the first is column {} of the table", before->index + 1));
        else
            columns.push_back({i, cell.column, name, unit, destination.values, destination.sensor});
    }
    if (has_errors(faults))
        return columns;
    if (std::ranges::find(columns, "time", &Column::name) == columns.end())
        faults.push_back(
            error_at(header.line, 1, "there is no column \"time\"", "the first column is mostly time [s]"));
    else if (columns.size() == 1)
        faults.push_back(
            error_at(header.line, 1, "no column of a sensor", "LINK.SENSOR, such as boom.inlet_pressure [psi]"));
    return columns;
}

/// In this room's unit.
double value_in(const TextRow& row, const Column& column, std::vector<Diagnostic>& faults) {
    const TextCell& cell = row.cells[column.index];
    double value = number_in(cell, row.line, faults) * column.unit->factor;
    if (std::abs(value) <= largest_reading)
        return value;
    faults.push_back(error_at(row.line, cell.column, fmt::format("{} is larger than anything measured", cell.text),
                              "leave a row out where a reading is missing"));
    return 0;
}

void check(Record& record, const TextTable& table, const std::vector<Column>& columns,
           std::vector<Diagnostic>& faults) {
    for (const Column& column : columns)
        if (HeaderPlace place{table.header.line, column.at}; column.sensor) {
            check_channel(column.name, *column.sensor, *column.unit, *column.values, place, faults);
            if (quantity_of(*column.sensor) == Quantity::pressure)
                check_pressure(column.name, *column.unit, *column.values, table, column.index, faults);
        } else {
            check_times(record, table, {column.index, place, *column.unit}, faults);
        }
}

/// Decimals that tell all times apart, as far as they were given.
int time_decimals(const Record& record) {
    int decimals = 3;
    for (double scale = 1e3; decimals < 9; ++decimals, scale *= 10)
        if (std::ranges::all_of(record.time_s, [scale](double time_s) {
                return std::abs(time_s * scale - std::round(time_s * scale)) < 1e-3;
            }))
            break;
    return decimals;
}

/// No "-0.000", whose sign could hang on a last bit.
std::string print_number(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

} // namespace

ReadRecord read_record(std::string_view text) {
    ReadRecord read;
    TextTable table = split_table(text, read.faults);
    if (table.rows.empty() && has_errors(read.faults))
        return read;
    if (table.header.cells.empty()) {
        read.faults.push_back(error_at(0, 0, "there is no header", "such as time [s],boom.inlet_pressure [psi]"));
        return read;
    }
    if (table.rows.empty()) { // a header, or a file whose line ends were lost
        read.faults.push_back(error_at(0, 0, fmt::format("0 samples, expected at least {}", fewest_samples),
                                       "below the header, a line for each instant; lines end in LF or in CR LF"));
        return read;
    }
    Record record;
    record.description = table.description;
    std::vector<Diagnostic> of_header;
    std::vector<Column> columns = read_header(table.header, record, of_header);
    read.faults.insert(read.faults.end(), of_header.begin(), of_header.end());
    if (has_errors(of_header))
        return read;
    drop_repeated_rows(table, read.faults);
    for (const TextRow& row : table.rows)
        for (const Column& column : columns)
            column.values->push_back(value_in(row, column, read.faults));
    bool whole = !has_errors(read.faults);
    if (whole && record.size() < fewest_samples)
        read.faults.push_back(
            error_at(0, 0, fmt::format("{} samples, expected at least {}", record.size(), fewest_samples), ""));
    else if (whole)
        check(record, table, columns, read.faults);
    std::ranges::stable_sort(read.faults, {}, [](const Diagnostic& fault) { return fault.location.line; });
    if (!has_errors(read.faults))
        read.record = std::move(record);
    return read;
}

std::string print_record(const Record& record) {
    struct Printed {
        const std::vector<double>* values;
        int decimals;
    };
    std::string text, description = record.description;
    for (std::size_t end; !description.empty(); description.erase(0, end + 1)) {
        end = std::min(description.find('\n'), description.size() - 1);
        text += fmt::format("# {}", description.substr(0, end + 1));
    }
    if (!text.empty() && text.back() != '\n')
        text += '\n';
    std::vector<Printed> channels{{&record.time_s, time_decimals(record)}};
    text += "time [s]";
    for (Link link : all_links)
        for (Sensor sensor : all_sensors)
            if (record.has(link, sensor)) {
                text += fmt::format(",{}.{} [{}]", name_of(link), name_of(sensor),
                                    units_of(quantity_of(sensor)).front().name);
                channels.push_back({&record.of(link, sensor), quantity_of(sensor) == Quantity::pressure ? 4 : 7});
            }
    text += '\n';
    for (std::size_t i = 0; i < record.size(); ++i)
        for (std::size_t c = 0; c < channels.size(); ++c)
            text +=
                print_number((*channels[c].values)[i], channels[c].decimals) + (c + 1 == channels.size() ? '\n' : ',');
    return text;
}

} // namespace placedpar::hydraulics
