#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

struct TextCell {
    std::string text; ///< without blanks at its beginning and end
    std::size_t column;
};

struct TextRow {
    std::size_t line;
    std::vector<TextCell> cells;
};

/// A table of comma-separated values. The first row is the header. Lines that start with '#' before the header describe
/// the table; later lines that start with '#' are comments. A line whose first cell is a spreadsheet's error word, such
/// as "#N/A", "#NV" or "#VALUE!", is a row. Blank lines are ignored. A cell in double quotes may contain commas; a
/// double quote in it is written twice. A row may have one separator more than the header, at its end. Lines end in LF
/// or CR LF; a byte order mark is skipped.
struct TextTable {
    char separator = ',';    ///< separates the cells of a line
    std::string description; ///< the lines before the header, without their "# "
    TextRow header;
    std::vector<TextRow> rows; ///< INVARIANT: each row has as many cells as the header
};

/// Splits a text into a table, and appends all faults to `faults`. Faults are: a quote that is not closed, a carriage
/// return within a line, a header with semicolons or tabs between its columns, and a row with more or fewer cells than
/// the header. Such a row is left out of the table. After a faulty header no rows are read. REQUIRES: `faults` has no
/// error yet.
TextTable split_table(std::string_view text, std::vector<Diagnostic>& faults);

/// Appends the next lines of a text that is read in pieces to a table. A piece consists of whole lines; its first line
/// has the number `number`. If the table has no header yet, the piece begins with the header. Returns the number of the
/// line after the piece.
std::size_t append_lines(TextTable& table, std::string_view text, std::size_t number, std::vector<Diagnostic>& faults);

/// Splits one line, without its end, into cells.
std::vector<TextCell> split_cells(std::string_view line, char separator);

/// Returns the number in a cell, which is written with this decimal sign. If the cell has no finite number, appends a
/// fault and returns 0.
double number_in(const TextCell& cell, std::size_t line, std::vector<Diagnostic>& faults, char decimal_sign = '.');

} // namespace placedpar
