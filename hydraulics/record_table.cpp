#include "hydraulics/record_table.hpp"

#include "hydraulics/record_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

/// What a column of the file holds.
struct Column {
    std::size_t index;
    std::size_t at; ///< column of its name in the header's line
    std::string name;
    const Unit* unit;
    std::vector<double>* values; ///< in the record
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
    Quantity quantity = Quantity::number;
};

Destination destination_of(const std::string& name, Record& record) {
    if (name == "time")
        return {&record.time_s, Quantity::time};
    std::size_t dot = name.find('.');
    auto link = link_named(name.substr(0, dot));
    auto sensor = dot == std::string::npos ? std::nullopt : sensor_named(std::string_view(name).substr(dot + 1));
    if (!link || !sensor)
        return {};
    return {&record.of(*link, *sensor), quantity_of(*sensor)};
}

std::vector<Column> read_header(const TextRow& header, Record& record, std::vector<TextFault>& faults) {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
        const TextCell& cell = header.cells[i];
        auto [name, unit_name] = name_and_unit(cell.text);
        auto refuse = [&](std::string message, std::string hint) {
            faults.push_back({true, header.line, cell.column, std::move(message), std::move(hint)});
        };
        Destination destination = destination_of(name, record);
        const Unit* unit = unit_named(unit_name);
        if (!destination.values)
            faults.push_back({false, header.line, cell.column, fmt::format("column \"{}\" is not used", name),
                              "columns are time and LINK.SENSOR, such as boom.inlet_pressure or bucket.angle"});
        else if (!unit || unit->quantity != destination.quantity)
            refuse(unit_name.empty()
                       ? fmt::format("column \"{}\" has no unit", name)
                       : fmt::format("\"{}\" is not a unit of {}", unit_name, name_of(destination.quantity)),
                   fmt::format("{} [UNIT] with {}", name, list_units(destination.quantity)));
        else if (std::ranges::find(columns, name, &Column::name) != columns.end())
            refuse(fmt::format("column \"{}\" is there twice", name), "");
        else
            columns.push_back({i, cell.column, name, unit, destination.values});
    }
    if (std::ranges::find(columns, "time", &Column::name) == columns.end() && !refuses(faults))
        faults.push_back({true, header.line, 1, "there is no column \"time\"", "the first column is mostly time [s]"});
    return columns;
}

} // namespace

ReadRecord read_record(std::string_view text) {
    ReadRecord read;
    TextTable table = split_table(text, read.faults);
    if (table.header.cells.empty()) {
        read.faults.push_back({true, 0, 0, "there is no header", "such as time [s],boom.inlet_pressure [psi]"});
        return read;
    }
    Record record;
    record.description = table.description;
    std::vector<Column> columns = read_header(table.header, record, read.faults);
    if (refuses(read.faults))
        return read;
    drop_repeated_rows(table, read.faults);
    for (const TextRow& row : table.rows)
        for (const Column& column : columns)
            column.values->push_back(number_in(row.cells[column.index], row.line, read.faults) * column.unit->factor);
    if (refuses(read.faults))
        return read;
    check_times(record, table, read.faults);
    for (const Column& column : columns)
        if (column.values != &record.time_s)
            check_channel(column.name, *column.unit, *column.values, {table.header.line, column.at}, read.faults);
    if (!refuses(read.faults))
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
    std::vector<Printed> channels{{&record.time_s, 3}};
    text += "time [s]";
    for (MachineLink link : all_links)
        for (Sensor sensor : all_sensors)
            if (record.has(link, sensor)) {
                text += fmt::format(",{}.{} [{}]", name_of(link), name_of(sensor),
                                    units_of(quantity_of(sensor)).front().name);
                channels.push_back({&record.of(link, sensor), quantity_of(sensor) == Quantity::pressure ? 4 : 7});
            }
    text += '\n';
    for (std::size_t i = 0; i < record.size(); ++i)
        for (std::size_t c = 0; c < channels.size(); ++c)
            text += fmt::format("{:.{}f}{}", (*channels[c].values)[i], channels[c].decimals,
                                c + 1 == channels.size() ? '\n' : ',');
    return text;
}

} // namespace placedpar
