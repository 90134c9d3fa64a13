#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

struct TextCell {
    std::string text; ///< without the blanks before and after the cell
    std::size_t column;
};

struct TextRow {
    std::size_t line;
    std::vector<TextCell> cells;
};

/// A table of comma-separated values. The first row is the header. Lines that start with '#' describe the table if they
/// come before the header, and are comments elsewhere, unless their first cell is a spreadsheet's error word such as
/// "#N/A", "#NV" or "#VALUE!". Blank lines are ignored. A cell in double quotes may contain commas, and double quotes
/// that are written twice. A row may end in a separator that the header does not have. Lines end in LF or CR LF; a byte
/// order mark is skipped.
struct TextTable {
    char separator = ',';    ///< separates the cells of a line
    std::string description; ///< the lines before the header, without their "# "
    TextRow header;
    std::vector<TextRow> rows; ///< INVARIANT: each row has as many cells as the header
};

/// Splits a text into a table, and appends all faults to `faults`. Faults are: a quote that is not closed, a carriage
/// return within a line, a header whose columns are separated by semicolons or tabs, and a row longer or shorter than
/// the header. The table leaves out rows of the wrong length. No rows are read after a faulty header. REQUIRES:
/// `faults` has no error yet.
TextTable split_table(std::string_view text, std::vector<Diagnostic>& faults);

/// Appends the lines of a text to a table. The text consists of whole lines, and its first line has the number
/// `number`. The header may have been in an earlier text. Returns the number of the line after the text.
std::size_t append_lines(TextTable& table, std::string_view text, std::size_t number, std::vector<Diagnostic>& faults);

/// Splits one line, without its end, into cells.
std::vector<TextCell> split_cells(std::string_view line, char separator);

/// Returns the cell's value if it is a finite number, written with the given decimal sign. Otherwise appends a fault
/// and returns 0.
double number_in(const TextCell& cell, std::size_t line, std::vector<Diagnostic>& faults, char decimal_sign = '.');

} // namespace placedpar
