#include "text/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace placedpar {

namespace {

constexpr std::string_view blanks = " \t\r";

/// Replaces each pair of successive double quotes by one double quote.
std::string unquoted(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if (text.substr(i, 2) == "\"\"")
            ++i;
    }
    return result;
}

TextCell trimmed(std::string_view text, std::size_t column) {
    std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {"", column};
    text = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
    column += first;
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return {unquoted(text.substr(1, text.size() - 2)), column + 1};
    return {std::string(text), column};
}

/// Splits a line into cells. Sets `open_quote` to the column of a quote that is not closed, or to 0 if all are closed.
std::vector<TextCell> split_line(std::string_view line, char separator, std::size_t& open_quote) {
    std::vector<TextCell> cells;
    std::size_t start = 0;
    bool quoted = false;
    open_quote = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"') {
            quoted = !quoted;
            open_quote = quoted ? i + 1 : 0;
        }
        if (i == line.size() || (line[i] == separator && !quoted)) {
            cells.push_back(trimmed(line.substr(start, i - start), start + 1));
            start = i + 1;
        }
    }
    return cells;
}

std::string_view without_mark(std::string_view comment) {
    comment.remove_prefix(1);
    if (comment.starts_with(' '))
        comment.remove_prefix(1);
    return comment.substr(0, comment.find_last_not_of(blanks) + 1);
}

void check_quotes(const TextRow& row, std::size_t open_quote, std::vector<Diagnostic>& faults) {
    if (open_quote > 0)
        faults.push_back(
            error_at(row.line, open_quote, "a quoted value has no closing quote", "close the quote on the same line"));
}

void check_line_end(std::string_view line, std::size_t number, std::vector<Diagnostic>& faults) {
    std::string_view inside = line.substr(0, line.find_last_not_of(blanks) + 1);
    if (std::size_t end = inside.find('\r'); end != std::string_view::npos)
        faults.push_back(
            error_at(number, end + 1, "the line has a carriage return before its end",
                     "lines end in LF or in CR LF; tr '\\r' '\\n' < FILE > NEW converts a file whose lines "
                     "end in carriage returns only"));
}

void check_header(std::string_view line, const TextTable& table, const TextRow& header,
                  std::vector<Diagnostic>& faults) {
    if (std::size_t mark = line.find_first_of(";\t");
        table.separator == ',' && header.cells.size() == 1 && mark != std::string_view::npos)
        faults.push_back(
            error_at(header.line, mark + 1,
                     fmt::format("the columns are separated by {}", line[mark] == ';' ? "semicolons" : "tabs"),
                     "separate the columns by commas, and write numbers with a decimal point"));
}

void add_row(TextTable& table, TextRow row, std::vector<Diagnostic>& faults) {
    if (row.cells.size() == table.header.cells.size() + 1 && row.cells.back().text.empty())
        row.cells.pop_back();
    if (row.cells.size() == table.header.cells.size())
        table.rows.push_back(std::move(row));
    else
        faults.push_back(error_at(
            row.line, row.cells.back().column,
            fmt::format("the row has the wrong number of values: {}, expected {}", row.cells.size(),
                        table.header.cells.size()),
            fmt::format("the header on line {} has {} columns", table.header.line, table.header.cells.size())));
}

/// Removes the first line from the text and returns it.
std::string_view take_line(std::string_view& text) {
    std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Returns whether the line begins with '#', and its first cell is not a spreadsheet's word for an error.
bool is_comment(std::string_view line, char separator) {
    constexpr std::array<std::string_view, 11> errors{"#N/A",  "#NV",    "#VALUE!", "#REF!",   "#DIV/0!", "#NAME?",
                                                      "#NUM!", "#NULL!", "#WERT!",  "#BEZUG!", "#ZAHL!"};
    if (!line.starts_with('#'))
        return false;
    const std::string first = trimmed(line.substr(0, line.find(separator)), 1).text;
    return std::ranges::find(errors, first) == errors.end();
}

bool is_blank(std::string_view line) { return line.find_first_not_of(blanks) == std::string_view::npos; }

/// Adds a line that is neither blank nor a comment: the header, or a row below it.
void add_line(TextTable& table, std::string_view line, std::size_t number, std::vector<Diagnostic>& faults) {
    std::size_t open_quote = 0;
    TextRow row{number, split_line(line, table.separator, open_quote)};
    check_quotes(row, open_quote, faults);
    if (!table.header.cells.empty())
        return add_row(table, std::move(row), faults);
    check_header(line, table, row, faults);
    table.header = std::move(row);
}

/// Returns whether a number outside the range of a double is too near to 0; otherwise it is too large.
bool is_tiny(std::string_view number) {
    return number.find("e-") != std::string_view::npos || number.find("E-") != std::string_view::npos;
}

} // namespace

TextTable split_table(std::string_view text, std::vector<Diagnostic>& faults) {
    TextTable table;
    append_lines(table, text, 1, faults);
    return table;
}

std::size_t append_lines(TextTable& table, std::string_view text, std::size_t number, std::vector<Diagnostic>& faults) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf"; // written by spreadsheets
    if (number == 1 && text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    for (; !text.empty(); ++number) {
        std::string_view line = take_line(text);
        bool above_header = table.header.cells.empty();
        check_line_end(line, number, faults);
        if (is_comment(line, table.separator) && above_header)
            table.description += std::string(without_mark(line)) + "\n";
        if (!is_blank(line) && !is_comment(line, table.separator))
            add_line(table, line, number, faults);
        bool was_header = above_header && !table.header.cells.empty();
        if (was_header && has_errors(faults)) // without a valid header the rows have no meaning
            break;
    }
    return number;
}

std::vector<TextCell> split_cells(std::string_view line, char separator) {
    std::size_t open_quote = 0;
    return split_line(line, separator, open_quote);
}

double number_in(const TextCell& cell, std::size_t line, std::vector<Diagnostic>& faults, char decimal_sign) {
    std::string text = cell.text;
    if (decimal_sign != '.') // a point is then not part of a number
        std::ranges::transform(text, text.begin(), [decimal_sign](char c) {
            return c == decimal_sign ? '.' : c == '.' ? decimal_sign : c;
        });
    double value = 0;
    const char* end = text.data() + text.size();
    const char* begin = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc() && stop == end && std::isfinite(value))
        return value;
    bool out_of_range = error == std::errc::result_out_of_range && stop == end;
    if (out_of_range && is_tiny(text))
        return 0;
    faults.push_back(
        error_at(line, cell.column,
                 cell.text.empty() ? "the value is missing"
                 : out_of_range    ? fmt::format("\"{}\" is beyond the range of numbers", cell.text)
                                   : fmt::format("\"{}\" is not a finite number", cell.text),
                 decimal_sign == '.'
                     ? "write a number such as 1830.5 or -2e-3; leave a row out where a reading is missing"
                     : "write a number such as 1830,5 or -2e-3, because this file has decimal commas; leave a row "
                       "out where a reading is missing"));
    return 0;
}

} // namespace placedpar
