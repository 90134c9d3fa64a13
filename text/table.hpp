#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

struct TextCell {
    std::string text; ///< without the blanks around it
    std::size_t column;
};

struct TextRow {
    std::size_t line;
    std::vector<TextCell> cells;
};

/// A table of comma-separated values: lines that start with '#' before the header describe it, elsewhere they
/// are comments; blank lines mean nothing; a cell in double quotes may hold commas, and quotes written twice. Lines end
/// in LF or CR LF; a byte order mark is skipped. The first row is the header.
struct TextTable {
    std::string description; ///< the lines before the header, without their "# "
    TextRow header;
    std::vector<TextRow> rows; ///< INVARIANT: each as long as the header
};

/// Splits a text into a table. Faults: a row longer or shorter than the header, which is left out; a quote that is not
/// closed, a carriage return within a line, a header whose columns are separated by semicolons or tabs. Below a faulty
/// header no row is read. Appends to the faults; they must hold no error yet.
TextTable split_table(std::string_view text, std::vector<Diagnostic>& faults);

/// Appends the lines of a text to a table. The text consists of whole lines, and begins with line `number`; the header
/// may stand in an earlier text. Returns the number of the line that would follow.
std::size_t append_lines(TextTable& table, std::string_view text, std::size_t number, std::vector<Diagnostic>& faults);

/// The cell as a finite number; a fault, and 0, when it is none.
double number_in(const TextCell& cell, std::size_t line, std::vector<Diagnostic>& faults);

} // namespace placedpar
