#include "report/field.hpp"

#include "text/paint.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

std::size_t width_of(const Table& table, std::size_t column) {
    const Field& head = table.head[column];
    std::size_t asked_for = head.width, widest = head.heading.size();
    for (const Row& row : table.rows) {
        asked_for = std::max(asked_for, row[column].width);
        widest = std::max(widest, row[column].text.size());
    }
    return asked_for > 0 ? asked_for : widest;
}

std::string line_of(const Row& row, const std::vector<std::size_t>& widths, std::string Field::*text) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i].column == Field::Column::right)
            line += fmt::format("{:>{}}  ", row[i].*text, widths[i]);
        else if (row[i].column == Field::Column::left)
            line += fmt::format("{:<{}}  ", row[i].*text, widths[i]);
    return line.erase(line.find_last_not_of(' ') + 1) + "\n";
}

std::string csv_cell(const boost::json::value& value) {
    if (!value.is_string())
        return value.is_null() ? "" : value.is_double() ? fmt::format("{}", value.get_double()) : serialize(value);
    std::string text = escaped(std::string(value.get_string()));
    if (text.find_first_of(",\"") == text.npos)
        return text;
    for (std::size_t i = 0; (i = text.find('"', i)) != text.npos; i += 2)
        text.insert(i, 1, '"');
    return "\"" + text + "\"";
}

template <class Cell>
std::string csv_line(const Row& row, Cell cell_of) {
    std::string line;
    for (const Field& field : row)
        if (!field.key.empty())
            line += csv_cell(cell_of(field)) + ",";
    line.back() = '\n';
    return line;
}

} // namespace

boost::json::object json_of(const Row& row) {
    boost::json::object json;
    for (const Field& field : row)
        if (!field.key.empty())
            json[field.key] = field.value;
    return json;
}

boost::json::array json_of(const std::vector<Row>& rows) {
    boost::json::array array;
    for (const Row& row : rows)
        array.push_back(json_of(row));
    return array;
}

std::string Table::text(const std::string& before) const {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < head.size(); ++i)
        widths.push_back(width_of(*this, i));
    std::string out = painted(Paint::heading, before + line_of(head, widths, &Field::heading));
    for (const Row& row : rows)
        out += line_of(row, widths, &Field::text);
    return out;
}

std::string Table::csv() const {
    std::string out = csv_line(head, [](const Field& field) { return boost::json::value(field.key); });
    for (const Row& row : rows)
        out += csv_line(row, [](const Field& field) { return field.value; });
    return out;
}

} // namespace placedpar
