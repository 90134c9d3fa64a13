#include "report/comparison.hpp"

#include "text/paint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace placedpar {

namespace {

using Cells = std::vector<Cell>;

constexpr std::size_t least_width = 7; // least width of a column of figures

struct ShownColumn {
    std::string name;
    /// Widths of the widest figures. `known` and `error` are 0 if no cell of the column has such a figure.
    std::size_t simulated = least_width, known = 0, error = 0;

    std::size_t width() const {
        return std::max(name.size(), simulated + 1 + (known ? known + 1 : 0) + (error ? error + 1 : 0));
    }
};

/// A table of adjacent rows that have the same columns.
struct ShownTable {
    std::vector<ShownColumn> columns;
    std::vector<Cells> rows;
    bool names_origins = false;

    bool has(const std::string& column) const {
        return std::ranges::find(columns, column, &ShownColumn::name) != columns.end();
    }
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

std::vector<ShownTable> tables_of(const Cells& cells) {
    std::vector<ShownTable> tables;
    for (const Cells& row : rows_of(cells)) {
        auto fits = [&](const Cell& cell) { return tables.back().has(cell.column); };
        if (tables.empty() || !std::ranges::all_of(row, fits)) {
            tables.emplace_back();
            for (const Cell& cell : row)
                tables.back().columns.push_back({cell.column});
        }
        tables.back().rows.push_back(row);
    }
    return tables;
}

std::string label(const Cell& cell) {
    return cell.unit.empty() ? cell.row : fmt::format("{} [{}]", cell.row, cell.unit);
}

/// Returns the width of the labels' column, computed as if every label had a unit.
std::size_t label_width(const Cells& cells) {
    std::size_t width = 0;
    for (const Cell& cell : cells)
        width = std::max(width, cell.row.size() + cell.unit.size() + 3);
    return width;
}

std::string mark(const Cell& cell, bool names_origins) {
    constexpr std::array letters{" ", "c", "w", "f", "k"};
    if (cell.origin == Origin::outcome || names_origins)
        return cell.within_tolerance() ? " " : "!";
    return letters[static_cast<std::size_t>(cell.origin)];
}

std::string without_trailing_zeros(std::string number) {
    if (number.find('.') == std::string::npos)
        return number;
    number.erase(number.find_last_not_of('0') + 1);
    return number.back() == '.' ? number.substr(0, number.size() - 1) : number;
}

/// Returns the difference as +.00006, without the zero before the point; "0" if all printed digits are 0.
std::string print_difference(double difference, int decimals) {
    std::string text = fmt::format("{:+.{}f}", difference, decimals);
    if (text.find_first_of("123456789") == std::string::npos)
        return "0";
    return text[1] == '0' ? text.erase(1, 1) : text;
}

std::string print_bound(const char* sign, double bound, int decimals) {
    return sign + without_trailing_zeros(fmt::format("{:.{}f}", bound, decimals));
}

std::string print_simulated(const Cell& cell) {
    if (!std::isfinite(cell.simulated))
        return "-";
    double simulated = std::abs(cell.simulated) < 0.5 * std::pow(10, -cell.decimals) ? 0 : cell.simulated; // not -0.00
    return fmt::format("{:.{}f}", simulated, cell.decimals);
}

std::string print_known(const Cell& cell) {
    auto print = [&](double known) { return without_trailing_zeros(fmt::format("{:.{}f}", known, cell.decimals)); };
    if (!cell.reference)
        return "";
    return print(*cell.reference) + (cell.reference_to ? "-" + print(*cell.reference_to) : "");
}

std::string print_bounds(const Cell& cell) {
    const std::string low = cell.at_least ? print_bound(">= ", *cell.at_least, cell.decimals) : "";
    const std::string high = cell.at_most ? print_bound("<= ", *cell.at_most, cell.decimals) : "";
    return low + (low.empty() || high.empty() ? "" : ", ") + high;
}

std::string print_error(const Cell& cell, const std::string& against) {
    if (cell.at_least || cell.at_most)
        return print_bounds(cell);
    if (!std::isfinite(cell.simulated))
        return "";
    if (cell.reference && (cell.tolerance || cell.unit == "%"))
        return print_difference(cell.simulated - *cell.reference, cell.decimals);
    auto error = against == "claim" ? std::nullopt : cell.error_percent();
    return error ? fmt::format("{:+.1f}%", *error) : "";
}

/// Returns the tolerance in the cell's unit or in percent. Returns "" if the cell is not judged, or if a bound judges
/// the cell. The bound is then printed in place of the error.
std::string print_tolerance(const Cell& cell) {
    if (cell.at_least || cell.at_most || !cell.reference)
        return "";
    if (cell.tolerance)
        return fmt::format("{:.3g}", *cell.tolerance);
    return cell.tolerance_percent ? fmt::format("{:g}%", *cell.tolerance_percent) : "";
}

/// Returns the row's different tolerances in the order of its columns.
std::string print_tolerances(const Cells& row) {
    std::vector<std::string> each;
    for (const Cell& cell : row)
        if (std::string tolerance = print_tolerance(cell);
            !tolerance.empty() && std::ranges::find(each, tolerance) == each.end())
            each.push_back(tolerance);
    return fmt::format("{}", fmt::join(each, ", "));
}

bool has_tolerances(const ShownTable& table) {
    return std::ranges::any_of(table.rows, [](const Cells& row) { return !print_tolerances(row).empty(); });
}

bool has_sources(const ShownTable& table) {
    return std::ranges::any_of(table.rows, [](const Cells& row) { return !row.front().source.empty(); });
}

/// Widens the column for the figure, unless the figure is empty.
void widen(std::size_t& width, const std::string& figure) {
    if (!figure.empty())
        width = std::max({width, figure.size(), least_width});
}

/// Sets the widths of the table's columns, and whether its rows name their origins.
ShownTable with_what_is_shown(ShownTable table, const Comparison& comparison) {
    const std::string& against = comparison.against;
    table.names_origins = comparison.names_origins;
    for (ShownColumn& column : table.columns)
        for (const Cells& row : table.rows)
            if (auto cell = std::ranges::find(row, column.name, &Cell::column); cell != row.end()) {
                widen(column.simulated, print_simulated(*cell));
                widen(column.known, print_known(*cell));
                widen(column.error, print_error(*cell, against));
            }
    return table;
}

/// Returns a blank and the text, right-aligned to the width. A width of 0 means that the column has no such figures;
/// the result is then "".
std::string in_width(const std::string& text, std::size_t width) {
    return width ? fmt::format(" {:>{}}", text, width) : "";
}

std::string print_cell(const Cell& cell, const ShownColumn& column, const std::string& against, bool names_origins) {
    return fmt::format("{:>{}}", print_simulated(cell), column.simulated) + in_width(print_known(cell), column.known) +
           in_width(print_error(cell, against), column.error) + mark(cell, names_origins);
}

std::string print_row(const Cells& row, const ShownTable& table, const std::string& against, std::size_t width) {
    std::string out = fmt::format("\n{:<{}}", label(row.front()), width);
    for (const ShownColumn& column : table.columns) {
        auto cell = std::ranges::find(row, column.name, &Cell::column);
        out += fmt::format("  {:>{}}", cell == row.end() ? "" : print_cell(*cell, column, against, table.names_origins),
                           column.width());
    }
    if (has_tolerances(table))
        out += fmt::format("  {:<9}", print_tolerances(row));
    if (table.names_origins)
        out += fmt::format("  {:<10}", name_of(row.front().origin));
    out += "  " + row.front().source;
    out.erase(out.find_last_not_of(' ') + 1);
    return out;
}

/// Prints the two lines of headings. A heading ends one character to the right of its figures, above the marks that
/// follow figures.
std::string print_head(const ShownTable& table, const std::string& against, std::size_t width) {
    std::string names, figures;
    for (const ShownColumn& column : table.columns) {
        names += fmt::format("  {:>{}}", column.name, column.width());
        std::string each = fmt::format("{:>{}}", "simulat.", column.simulated + 1) + in_width(against, column.known) +
                           in_width("error", column.error);
        figures += fmt::format("  {:>{}}", each, column.width());
    }
    return fmt::format("\n{:<{}}{}\n{:<{}}{}{}{}{}", "", width, names, "", width, figures,
                       has_tolerances(table) ? "  tolerance" : "", table.names_origins ? "  mark      " : "",
                       has_sources(table) ? "  source" : "");
}

std::string print_table(const ShownTable& table, const std::string& against, std::size_t width) {
    std::string out = print_head(table, against, width);
    for (const Cells& row : table.rows)
        out += print_row(row, table, against, width);
    return out;
}

/// Returns whether the cell counts for the quality of the fit: an outcome with a known figure other than 0.
bool shows_fit(const Cell& cell) {
    return cell.origin == Origin::outcome && cell.error_percent() && *cell.reference != 0;
}

bool counts(const Comparison& comparison, const std::vector<Comparison>& all) {
    return &comparison == &all.front() || comparison.judged;
}

} // namespace

void Comparison::add(Cell cell) { cells.push_back(std::move(cell)); }

bool Comparison::within_tolerance() const { return std::ranges::all_of(cells, &Cell::within_tolerance); }

Judge Comparison::judge_of(const Cell& cell) const {
    if (cell.judge)
        return *cell.judge;
    if (against == "thesis" || against == "claim" || against.starts_with("eq.") || against.starts_with('('))
        return Judge::thesis;
    return against == "publ." || against == "Poznan" ? Judge::published : Judge::own;
}

JudgedCells count_judged(const std::vector<Comparison>& comparisons) {
    JudgedCells cells;
    for (const Comparison& comparison : comparisons)
        for (const Cell& cell : comparison.cells) {
            if (!counts(comparison, comparisons) || !cell.is_judged()) {
                ++cells.not_judged;
                continue;
            }
            const Judge judge = comparison.judge_of(cell);
            ++(judge == Judge::thesis ? cells.thesis : judge == Judge::published ? cells.published : cells.own);
            if (judge == Judge::thesis && cell.origin != Origin::outcome)
                ++cells.set_from_thesis;
        }
    return cells;
}

std::string print_judged(const JudgedCells& cells) {
    return fmt::format("cells judged against the thesis: {}{}; {}against own figures: {}; not judged: {}\n",
                       cells.thesis,
                       cells.set_from_thesis ? fmt::format(" ({} of them set constants)", cells.set_from_thesis) : "",
                       cells.published ? fmt::format("against published figures: {}; ", cells.published) : "",
                       cells.own, cells.not_judged);
}

std::string print_comparison(const Comparison& comparison) {
    std::string out = comparison.name;
    for (const ShownTable& table : tables_of(comparison.cells))
        out += print_table(with_what_is_shown(table, comparison), comparison.against, label_width(comparison.cells));
    return out + "\n" + comparison.notes;
}

bool are_within_tolerance(const std::vector<Comparison>& comparisons) {
    return std::ranges::all_of(
        comparisons, [&](const Comparison& each) { return !counts(each, comparisons) || each.within_tolerance(); });
}

bool is_any_judged(const std::vector<Comparison>& comparisons) {
    return std::ranges::any_of(comparisons, [&](const Comparison& each) {
        return counts(each, comparisons) && std::ranges::any_of(each.cells, &Cell::is_judged);
    });
}

std::string print_verdict(const std::vector<Comparison>& comparisons, const std::string& called) {
    const bool others = std::ranges::any_of(comparisons, &Comparison::judged),
               within = are_within_tolerance(comparisons);
    const std::string of_first = others ? "" : " of the first " + called;
    auto text = fmt::format("{} cell{} {}\n", within ? "every judged" : "a", of_first,
                            within ? "is within its tolerance" : "misses its tolerance");
    return painted(within ? Paint::success : Paint::failure, text);
}

std::string print_fit(const std::vector<Cell>& cells) {
    double squares = 0;
    int count = 0;
    const Cell* worst = nullptr;
    for (const Cell& cell : cells) {
        if (!shows_fit(cell) || cell.unit != cells.front().unit)
            continue;
        squares += *cell.error_percent() * *cell.error_percent();
        ++count;
        if (!worst || std::abs(*cell.error_percent()) > std::abs(*worst->error_percent()))
            worst = &cell;
    }
    return !worst ? ""
                  : fmt::format("outcomes: rms error {:.1f} %, greatest {:+.1f} % ({}, {})\n",
                                std::sqrt(squares / count), *worst->error_percent(), worst->row, worst->column);
}

} // namespace placedpar
