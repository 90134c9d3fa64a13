#pragma once

#include "occam/language/tree.hpp"
#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::occam {

enum class ErrorMode : std::uint8_t { halt, stop, universal };

struct CodeOptions {
    transputer::Model model{};
    ErrorMode mode = ErrorMode::halt;
    bool range_checks = true;    ///< of subscripts, segments, conversions, counts
    bool run_time_checks = true; ///< also of overflow
    bool vector_space = true;    ///< arrays outside of the workspace
    bool ends_run = true;        ///< a main procedure without channels tells the host at its end
    bool awaits_high = true;     ///< a PRI PAR of the main procedure waits for its component of high priority
};

/// Code at an offset came from a place of a file.
struct CodeLine {
    std::uint32_t offset = 0;
    Place place;
};
/// A name of code: the entry of a procedure, or of a component of a PAR.
struct CodeName {
    std::uint32_t offset = 0;
    std::string name; ///< such as "phil" or "phil/PAR 12:3"
};

/// A process that is a component of the main procedure's PAR, with the words of its workspace and of all that it calls.
/// They count from the first workspace pointer, and are below it.
struct CodeWorkspace {
    std::int64_t from = 0, until = 0;
    std::string name;     ///< of the PROC that it is an instance of, with its place if there are several; or its place
    std::string place;    ///< of the component: line and column, "12:3"
    std::string entry;    ///< name of its code, among Code::names
    bool carries = false; ///< it carries messages of other processes; the compiler does not know
};

/// A channel that the main procedure declares outside of its process.
struct CodeChannel {
    std::int64_t word = 0;  ///< from the first workspace pointer, or from the start of memory if it is placed
    bool is_placed = false; ///< at an address
    std::string name;
};

/// Code of a program that can stand anywhere in memory.
struct Code {
    std::vector<std::uint8_t> bytes;
    std::uint32_t entry = 0;                 ///< offset of the first instruction, which needs no values in registers
    std::uint32_t end = 0;                   ///< offset behind the last instruction, which stops the first process
    std::uint64_t workspace_words = 0;       ///< of the first process, with those of everything it calls
    std::uint64_t first_workspace_words = 0; ///< those of them that the first workspace pointer has above it
    std::uint64_t vector_space_bytes = 0;    ///< behind the code
    std::vector<CodeLine> lines;             ///< in order of offsets
    std::vector<CodeName> names;
    std::vector<CodeWorkspace> workspaces; ///< in order of the text; empty if several PARs share the words
    std::vector<CodeChannel> channels;
};

} // namespace placedpar::occam
