#include "experiments/kit/reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace placedpar {

namespace {

using Cells = std::vector<Cell>;

/// Adjacent rows that share their columns.
struct Table {
    std::vector<std::string> columns;
    std::vector<Cells> rows;

    bool has(const std::string& column) const { return std::ranges::find(columns, column) != columns.end(); }
};

std::vector<Cells> rows_of(const Cells& cells) {
    std::vector<Cells> rows;
    for (const Cell& cell : cells) {
        auto row = std::ranges::find_if(rows, [&](const Cells& other) { return other.front().row == cell.row; });
        if (row == rows.end())
            row = rows.insert(row, Cells());
        row->push_back(cell);
    }
    return rows;
}

std::vector<Table> tables_of(const Cells& cells) {
    std::vector<Table> tables;
    for (const Cells& row : rows_of(cells)) {
        auto fits = [&](const Cell& cell) { return tables.back().has(cell.column); };
        if (tables.empty() || !std::ranges::all_of(row, fits)) {
            tables.emplace_back();
            for (const Cell& cell : row)
                tables.back().columns.push_back(cell.column);
        }
        tables.back().rows.push_back(row);
    }
    return tables;
}

std::string label(const Cell& cell) {
    return cell.unit.empty() ? cell.row : fmt::format("{} [{}]", cell.row, cell.unit);
}

std::string mark(const Cell& cell) {
    switch (cell.origin) {
    case Origin::outcome: return cell.within_tolerance() ? " " : "!";
    case Origin::calibrated: return "c";
    case Origin::workload: return "w";
    }
    return "";
}

std::string without_trailing_zeros(std::string number) {
    if (number.find('.') != std::string::npos) {
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.')
            number.pop_back();
    }
    return number;
}

/// Such as +.00006; "0" where nothing is left of it at these decimals.
std::string print_difference(double difference, int decimals) {
    std::string text = fmt::format("{:+.{}f}", difference, decimals);
    if (text.find_first_of("123456789") == std::string::npos)
        return "0";
    return text[1] == '0' ? text.erase(1, 1) : text;
}

std::string print_bound(const char* sign, double bound, int decimals) {
    return sign + without_trailing_zeros(fmt::format("{:.{}f}", bound, decimals));
}

std::string print_error(const Cell& cell) {
    if (cell.at_least)
        return print_bound(">= ", *cell.at_least, cell.decimals);
    if (cell.at_most)
        return print_bound("<= ", *cell.at_most, cell.decimals);
    if (cell.thesis && (cell.tolerance || cell.unit == "%"))
        return print_difference(cell.simulated - *cell.thesis, cell.decimals);
    auto error = cell.error_percent();
    return error ? fmt::format("{:+.1f}%", *error) : "";
}

std::string print_cell(const Cell& cell) {
    double simulated = std::abs(cell.simulated) < 0.5 * std::pow(10, -cell.decimals) ? 0 : cell.simulated; // no -0.00
    std::string thesis = cell.thesis ? without_trailing_zeros(fmt::format("{:.{}f}", *cell.thesis, cell.decimals)) : "";
    return fmt::format("{:7.{}f} {:>7} {:>7}{}", simulated, cell.decimals, thesis, print_error(cell), mark(cell));
}

std::string print_row(const Cells& row, const Table& table, std::size_t width) {
    std::string out = fmt::format("\n{:<{}}", label(row.front()), width);
    for (const std::string& column : table.columns) {
        auto cell = std::ranges::find(row, column, &Cell::column);
        out += "  " + (cell == row.end() ? std::string(24, ' ') : print_cell(*cell));
    }
    out.erase(out.find_last_not_of(' ') + 1);
    return out;
}

std::string print_table(const Table& table, const std::string& against, std::size_t width) {
    std::string out = fmt::format("\n{:<{}}", "", width);
    for (const std::string& column : table.columns)
        out += fmt::format("  {:>24}", column);
    out += fmt::format("\n{:<{}}", "", width);
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        out += fmt::format("  simulat.{:>8}   error ", against);
    out.pop_back();
    for (const Cells& row : table.rows)
        out += print_row(row, table, width);
    return out;
}

} // namespace

const char* name_of(Origin origin) {
    switch (origin) {
    case Origin::outcome: return "outcome";
    case Origin::calibrated: return "calibrated";
    case Origin::workload: return "workload";
    }
    return "";
}

std::optional<double> Cell::error_percent() const {
    if (!thesis)
        return std::nullopt;
    if (*thesis == 0)
        return simulated == 0 ? std::optional(0.0) : std::nullopt;
    return 100 * (simulated - *thesis) / std::abs(*thesis);
}

std::optional<double> Cell::tolerance_in_percent() const {
    if (!tolerance)
        return tolerance_percent;
    return thesis && *thesis != 0 ? std::optional(100 * *tolerance / std::abs(*thesis)) : std::nullopt;
}

bool Cell::within_tolerance() const {
    if (at_least || at_most)
        return simulated >= at_least.value_or(simulated) && simulated <= at_most.value_or(simulated);
    if (tolerance)
        return thesis && std::abs(simulated - *thesis) <= *tolerance;
    if (!tolerance_percent)
        return true;
    auto error = error_percent();
    return error && std::abs(*error) <= *tolerance_percent;
}

bool within_tolerance(const Reading& reading) { return std::ranges::all_of(reading.cells, &Cell::within_tolerance); }

std::string print_reading(const Reading& reading) {
    std::size_t width = 0;
    for (const Cell& cell : reading.cells)
        width = std::max(width, fmt::format("{} [{}]", cell.row, cell.unit).size());
    std::string out = reading.name;
    for (const Table& table : tables_of(reading.cells))
        out += print_table(table, reading.against, width);
    return out + "\n" + reading.notes;
}

} // namespace placedpar
