#include "experiments/kit/comparison.hpp"

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

/// The column of labels is as wide as with every unit shown, an empty one too.
std::size_t label_width(const Cells& cells) {
    std::size_t width = 0;
    for (const Cell& cell : cells)
        width = std::max(width, cell.row.size() + cell.unit.size() + 3);
    return width;
}

std::string mark(const Cell& cell) {
    if (cell.origin == Origin::outcome)
        return cell.within_tolerance() ? " " : "!";
    return cell.origin == Origin::calibrated ? "c" : "w";
}

std::string without_trailing_zeros(std::string number) {
    if (number.find('.') == std::string::npos)
        return number;
    number.erase(number.find_last_not_of('0') + 1);
    return number.back() == '.' ? number.substr(0, number.size() - 1) : number;
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
    if (cell.reference && (cell.tolerance || cell.unit == "%"))
        return print_difference(cell.simulated - *cell.reference, cell.decimals);
    auto error = cell.error_percent();
    return error ? fmt::format("{:+.1f}%", *error) : "";
}

std::string print_cell(const Cell& cell) {
    double simulated = std::abs(cell.simulated) < 0.5 * std::pow(10, -cell.decimals) ? 0 : cell.simulated; // no -0.00
    std::string known =
        cell.reference ? without_trailing_zeros(fmt::format("{:.{}f}", *cell.reference, cell.decimals)) : "";
    return fmt::format("{:7.{}f} {:>7} {:>7}{}", simulated, cell.decimals, known, print_error(cell), mark(cell));
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

std::string print_head(const Table& table, const std::string& against, std::size_t width) {
    std::string names, figures;
    for (const std::string& column : table.columns) {
        names += fmt::format("  {:>24}", column);
        figures += fmt::format("  simulat.{:>8}   error ", against);
    }
    figures.pop_back();
    return fmt::format("\n{:<{}}{}\n{:<{}}{}", "", width, names, "", width, figures);
}

std::string print_table(const Table& table, const std::string& against, std::size_t width) {
    std::string out = print_head(table, against, width);
    for (const Cells& row : table.rows)
        out += print_row(row, table, width);
    return out;
}

} // namespace

void Comparison::add(Cell cell) { cells.push_back(std::move(cell)); }

bool Comparison::within_tolerance() const { return std::ranges::all_of(cells, &Cell::within_tolerance); }

std::string print_comparison(const Comparison& comparison) {
    std::string out = comparison.name;
    for (const Table& table : tables_of(comparison.cells))
        out += print_table(table, comparison.against, label_width(comparison.cells));
    return out + "\n" + comparison.notes;
}

} // namespace placedpar
