#pragma once

#include "runtime/transputer/model.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::transputer {

/// An error in a table, with its place. Lines and columns count from 1.
struct CodeLinesError : std::runtime_error {
    CodeLinesError(const std::string& what, std::size_t at_line, std::size_t at_column)
        : runtime_error(what), line(at_line), column(at_column) {}
    std::size_t line, column;
};

/// A compiler's table that relates the code and the workspaces of a transputer to the source, for reports and traces.
/// Each row of the table has one of these forms:
///
///     code FROM UNTIL LINE COLUMN FILE   the code in [FROM, UNTIL) is for this place; no two rows overlap
///     entry ADDRESS NAME                 a procedure begins here
///     process FROM UNTIL NAME            a process whose workspace is in [FROM, UNTIL); no two rows overlap
///     error ADDRESS TEXT                 the meaning if the instruction before ADDRESS sets Error, or is a
///                                        `stopp`; see print_error() and error_to_name()
///     carrier FROM UNTIL NAME            like `process`, for a process that only carries messages of others
///     channel ADDRESS NAME               the word of a channel
///     node NAME                          the rows that follow are for the node of this name
///     end                                the last row
///
/// An address is hexadecimal, such as #80000170, or an offset from MemStart, such as +#100. FILE, NAME and TEXT extend
/// to the end of the line. A node is a transputer. Rows before the first `node` are for the transputer that the table's
/// program boots. Empty lines and lines that begin with -- are comments.
class CodeLines {
public:
    CodeLines() = default;
    /// Reads the rows for one node, and checks all rows. `node` is "" for the transputer that the program boots.
    /// `memory_start`: the address of MemStart. Throws CodeLinesError if the table has an error.
    CodeLines(std::string_view table, std::string_view node, Word memory_start);

    /// Returns the place of code, such as "ring.occ:12:3", or else its distance from the start of its procedure, such
    /// as "philosopher+#12". Returns "" if the table has neither.
    std::string place(Word address) const;
    /// Returns the place of code in a file; "" if the table has none.
    std::string file_place(Word address) const;
    /// Returns the name of the procedure that begins at an address; "" if none does.
    std::string entry(Word address) const;
    /// Returns the name of the process that has this workspace; "" if the table has none.
    std::string process(Word workspace) const;
    /// Returns whether the process that has this workspace only carries messages of other processes. Reports of
    /// deadlocks leave such processes out, and name the processes at the ends of the channel.
    bool is_carrier(Word workspace) const;
    /// Returns the name of the channel whose word this is; "" if the table has none.
    std::string channel(Word word) const;

    /// Returns the text for an error of the instruction that ends before an address; "" if the table has none.
    std::string_view error(Word address) const;

private:
    struct Row {
        Word from, until; ///< for an entry, `until` equals `from`
        std::string text;
        std::size_t line; ///< line of the table
        bool is_carrier = false;
    };
    class Reader;
    std::vector<Row> code_, entries_, processes_, channels_, errors_; ///< by address
};

} // namespace placedpar::transputer
