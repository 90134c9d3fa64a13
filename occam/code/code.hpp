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
/// A name of code: the entry of a procedure, or of a component of a PAR.
struct CodeName {
    std::uint32_t offset = 0;
    std::string name; ///< such as "phil" or "phil/PAR 12:3"
};

/// The meaning of an error of the instruction that ends at an offset: a text for transputer::print_error().
struct CodeError {
    std::uint32_t offset = 0;
    std::string text;
};

/// Where the workspace pointer of a process can be, including the procedures that it calls. The words count from the
/// first workspace pointer, and are below it.
struct CodeWorkspace {
    /// The number of the process that starts the outermost components.
    static constexpr std::size_t first_process = static_cast<std::size_t>(-1);

    std::int64_t from = 0, until = 0;
    /// A name such as "phil[2]", or the process's place. If several processes have the same name, the place is added.
    /// Processes that use the same words one after the other share a name: "reader or writer".
    std::string name;
    std::string inner = {}; ///< name within the outermost component, "fork[1]" if `name` is "ring/fork[1]"; "" for the
                            ///< outermost component itself
    std::size_t outermost = 0; ///< number of the outermost component, in the order of the text
    std::string entry = {};    ///< name of the code of the process, among Code::names; "" of a replicated one
    bool carries = false;      ///< it carries messages of other processes; the compiler does not know
};

/// A channel that the main procedure declares outside of its process.
struct CodeChannel {
    std::int64_t word = 0;  ///< from the first workspace pointer, or from the start of memory if it is placed
    bool is_placed = false; ///< it is placed at an address
    std::string name;
};

/// Position-independent code of a program.
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
