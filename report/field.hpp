#pragma once

#include "runtime/time.hpp"

#include <boost/json.hpp>

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// Describes one fact of a report's row: its text below a heading in a table for people, and its value under a key in a
/// document for programs. A field may be only in tables, or only in documents.
struct Field {
    std::string heading, text;
    std::size_t width = 0; ///< least width of the column in characters; 0 in all rows: the column is as wide as its
                           ///< widest text or its heading
    enum class Column { none, left, right } column = Column::none;
    std::string key = ""; ///< "": not in documents
    boost::json::value value = nullptr;

    static Field left(std::size_t width, std::string heading, std::string text) {
        return {std::move(heading), std::move(text), width, Column::left};
    }
    static Field right(std::size_t width, std::string heading, std::string text) {
        return {std::move(heading), std::move(text), width, Column::right};
    }
    /// Returns a number whose heading in a table is also its key in a document.
    static Field count(std::size_t width, const std::string& name, std::integral auto number) {
        return right(width, name, std::to_string(number)).as(name, number);
    }
    /// Returns a field that only documents have.
    static Field member(std::string key, const auto& value) { return Field().as(std::move(key), value); }
    /// Returns a field for a time in picoseconds that only documents have: "busy_ps". The member is missing if there is
    /// no time.
    static Field member_ps(const std::string& key, std::optional<Time> time) {
        return time ? member(key + "_ps", time->count()) : Field();
    }

    /// These two functions add the fact to documents. Its value is `its_value`, or else the text.
    Field as(std::string its_key, const auto& its_value) && {
        key = std::move(its_key);
        value = boost::json::value(its_value);
        return std::move(*this);
    }
    Field as(std::string its_key) && { return std::move(*this).as(std::move(its_key), text); }
    Field shown_if(bool shown) && {
        column = shown ? column : Column::none;
        return std::move(*this);
    }
};

using Row = std::vector<Field>;

boost::json::object json_of(const Row&);
boost::json::array json_of(const std::vector<Row>&);

/// Holds rows of the same fields.
struct Table {
    Row head; ///< headings, widths and keys of the columns, also if there are no rows
    std::vector<Row> rows;

    /// Returns the table for people: `before`, a line of headings, and a line for each row, without trailing blanks.
    std::string text(const std::string& before = "") const;
    /// Returns the table as comma-separated values: a line of keys and a line for each row. A cell without a value is
    /// empty.
    std::string csv() const;
};

/// Makes a table with a row for each of `things`. `row_of` returns the row of one thing. For the headings `row_of` is
/// called with a default-constructed thing.
template <class Things, class RowOf>
Table table_of(const Things& things, RowOf row_of) {
    Table table{row_of(typename Things::value_type()), {}};
    for (const auto& each : things)
        table.rows.push_back(row_of(each));
    return table;
}

} // namespace placedpar
