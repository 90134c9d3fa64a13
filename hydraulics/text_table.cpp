#include "hydraulics/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace placedpar {

namespace {

constexpr std::string_view blanks = " \t\r";

TextCell trimmed(std::string_view text, std::size_t column) {
    std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {"", column};
    text = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
    column += first;
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return {std::string(text.substr(1, text.size() - 2)), column + 1};
    return {std::string(text), column};
}

std::vector<TextCell> split_line(std::string_view line) {
    std::vector<TextCell> cells;
    std::size_t start = 0;
    bool quoted = false;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"')
            quoted = !quoted;
        if (i == line.size() || (line[i] == ',' && !quoted)) {
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

} // namespace

TextTable split_table(std::string_view text, std::vector<TextFault>& faults) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf"; // as spreadsheets write it
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    TextTable table;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.find_first_not_of(blanks) == std::string_view::npos)
            continue;
        if (line.starts_with('#')) {
            if (table.header.cells.empty())
                table.description += std::string(without_mark(line)) + "\n";
            continue;
        }
        TextRow row{number, split_line(line)};
        if (table.header.cells.empty())
            table.header = std::move(row);
        else if (row.cells.size() == table.header.cells.size())
            table.rows.push_back(std::move(row));
        else
            faults.push_back(
                {true, number, row.cells.back().column,
                 fmt::format("{} values, expected {}", row.cells.size(), table.header.cells.size()),
                 fmt::format("the header on line {} has {} columns", table.header.line, table.header.cells.size())});
    }
    return table;
}

double number_in(const TextCell& cell, std::size_t line, std::vector<TextFault>& faults) {
    double value = 0;
    const char* end = cell.text.data() + cell.text.size();
    auto [stop, error] = std::from_chars(cell.text.data(), end, value);
    if (error == std::errc() && stop == end && std::isfinite(value))
        return value;
    faults.push_back({true, line, cell.column,
                      cell.text.empty() ? "no value" : fmt::format("\"{}\" is not a finite number", cell.text),
                      "a number such as 1830.5 or -2e-3; leave a row out where a reading is missing"});
    return 0;
}

bool refuses(const std::vector<TextFault>& faults) { return std::ranges::any_of(faults, &TextFault::refused); }

} // namespace placedpar
