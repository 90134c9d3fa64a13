#pragma once

#include "occam/language/tree.hpp"
#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

enum class ErrorMode : std::uint8_t { halt, stop, universal };

/// Returns the mode of this name: what an error at run time stops. Throws std::invalid_argument if no mode has this
/// name.
ErrorMode error_mode(std::string_view name);

struct CodeOptions {
    transputer::Model model{};
    ErrorMode mode = ErrorMode::halt;
    bool range_checks = true; ///< check subscripts, segments, conversions and counts at run time
    bool run_time_checks =
        true; ///< check for all errors at run time, such as overflow; false turns the range checks off, too
    bool vector_space = true; ///< place arrays in vector space, a memory apart from the workspaces
    bool ends_run = true; ///< a main procedure without channels tells the host at its end that the program has exited
    bool awaits_high = true; ///< a PRI PAR of the main procedure waits for its component of high priority
};

/// States that the code from an offset on was made from a place in a source file.
struct CodeLine {
    std::uint32_t offset = 0;
    Place place;
};
/// Gives a name to the code that begins at an offset: a procedure, or a component of a PAR.
struct CodeName {
    std::uint32_t offset = 0;
    std::string name; ///< such as "phil" or "phil/PAR 12:3"
};

/// States what it means if the instruction that ends at `offset` sets the error flag, such as an overflow. `text` has
/// the form that transputer::print_error() reads.
struct CodeError {
    std::uint32_t offset = 0;
    std::string text;
};

/// Describes the workspace of a process, so that reports can name the process to which a workspace pointer belongs.
/// While the process, or a procedure that it calls, is executed, the workspace pointer is at a word from `from` up to,
/// but without, `until`. Words are counted from the first workspace pointer of the program; workspaces grow downwards,
/// so that most numbers are negative.
struct CodeWorkspace {
    /// The value of `outermost` for the first process of the program, which starts the outermost components of PARs.
    static constexpr std::size_t first_process = static_cast<std::size_t>(-1);

    std::int64_t from = 0, until = 0;
    /// Holds a name such as "phil[2]", or the place of the process in the source. If several processes have the same
    /// name, the place is added to the name. If several processes use the same words, one after the other, `name` has
    /// all their names: "reader or writer".
    std::string name;
    std::string inner = {}; ///< name without that of the outermost component: "fork[1]" if `name` is "ring/fork[1]"; ""
                            ///< for the outermost component itself
    std::size_t outermost =
        0; ///< number of the outermost component that contains the process, in the order of the text
    std::string entry =
        {}; ///< name of the code of the process, as in Code::names; "" for a component of a replicated PAR
    bool carries = false; ///< the process only passes on messages of other processes; set later, by the code that joins
                          ///< the processes of a node to one program
};

/// Describes a channel that the main procedure declares at its outermost level.
struct CodeChannel {
    std::int64_t word = 0;  ///< word of the channel, counted from the first workspace pointer; if `is_placed`, counted
                            ///< from the start of memory
    bool is_placed = false; ///< a PLACE states the channel's address
    std::string name;
};

/// Holds the machine code of a compiled program, which works at any address, and tables about the code.
struct Code {
    std::vector<std::uint8_t> bytes;
    std::uint32_t entry =
        0; ///< offset of the first instruction; execution begins here with any values in the registers
    std::uint32_t constants = 0;       ///< offset of the constants, which follow the instructions
    std::uint32_t end = 0;             ///< offset after the last instruction, at which the first process stops
    std::uint64_t workspace_words = 0; ///< words in the workspaces of the first process, of the procedures that it
                                       ///< calls, and of all processes that they start
    std::uint64_t first_workspace_words = 0; ///< number of these words that are above the first workspace pointer
    std::uint64_t vector_space_bytes = 0; ///< size of the vector space, the memory for arrays, which follows the code
    std::vector<CodeLine> lines;          ///< in order of offsets
    std::vector<CodeName> names;
    std::vector<CodeError> errors; ///< in order of offsets
    std::vector<CodeWorkspace> workspaces;
    std::vector<CodeChannel> channels;
};

} // namespace placedpar::occam
