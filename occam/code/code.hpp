#pragma once

#include "occam/language/tree.hpp"
#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::occam {

enum class ErrorMode : std::uint8_t { halt, stop, universal };

/// Returns the mode of this name. Throws std::invalid_argument if there is none.
ErrorMode error_mode(std::string_view name);

struct CodeOptions {
    transputer::Model model{};
    ErrorMode mode = ErrorMode::halt;
    bool range_checks = true;    ///< check subscripts, segments, conversions, counts
    bool run_time_checks = true; ///< check anything at run time, including overflow
    bool vector_space = true;    ///< place arrays outside of the workspace
    bool ends_run = true;        ///< a main procedure without channels tells the host at its end
    bool awaits_high = true;     ///< a PRI PAR of the main procedure waits for its component of high priority
};

/// States the place in a file from which the code at an offset was made.
struct CodeLine {
    std::uint32_t offset = 0;
    Place place;
};
/// Names the code that begins at an offset: a procedure, or a component of a PAR.
struct CodeName {
    std::uint32_t offset = 0;
    std::string name; ///< such as "phil" or "phil/PAR 12:3"
};

/// States what an error of the instruction that ends at `offset` means: `text` is a text for transputer::print_error().
struct CodeError {
    std::uint32_t offset = 0;
    std::string text;
};

/// Describes the workspace of a process, including the procedures that it calls: its workspace pointer is from `from`
/// to before `until`. These words are below the first workspace pointer of the program, and count from it.
struct CodeWorkspace {
    /// The number of the process that starts the outermost components.
    static constexpr std::size_t first_process = static_cast<std::size_t>(-1);

    std::int64_t from = 0, until = 0;
    /// A name such as "phil[2]", or the process's place in the source. If several processes have the same name, the
    /// place is added to the name. If processes use the same words one after the other, the workspace has the names of
    /// all: "reader or writer".
    std::string name;
    std::string inner = {}; ///< name within the outermost component, "fork[1]" if `name` is "ring/fork[1]"; "" for the
                            ///< outermost component itself
    std::size_t outermost = 0; ///< number of the outermost component, in the order of the text
    std::string entry = {};    ///< name of the process's code in Code::names; "" for a component of a replicated PAR
    bool carries = false;      ///< it carries messages of other processes; not set by the compiler
};

/// Describes a channel that the main procedure declares before its process.
struct CodeChannel {
    std::int64_t word = 0;  ///< word of the channel, counted from the first workspace pointer, or from the start of
                            ///< memory if the channel is placed
    bool is_placed = false; ///< a PLACE states the channel's address
    std::string name;
};

/// Holds the position-independent code of a program.
struct Code {
    std::vector<std::uint8_t> bytes;
    std::uint32_t entry = 0;                 ///< offset of the first instruction, which needs no values in registers
    std::uint32_t constants = 0;             ///< offset of the constants, which follow the instructions
    std::uint32_t end = 0;                   ///< offset after the last instruction, which stops the first process
    std::uint64_t workspace_words = 0;       ///< words of the first process, including the procedures that it calls
    std::uint64_t first_workspace_words = 0; ///< number of these words above the first workspace pointer
    std::uint64_t vector_space_bytes = 0;    ///< size of the vector space, which follows the code
    std::vector<CodeLine> lines;             ///< in order of offsets
    std::vector<CodeName> names;
    std::vector<CodeError> errors; ///< in order of offsets
    std::vector<CodeWorkspace> workspaces;
    std::vector<CodeChannel> channels;
};

} // namespace placedpar::occam
