#pragma once

#include "app/options.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "occam/code/compile.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The options of a command that compiles occam.
struct OccamOptions {
    std::string mode = "halt";
    std::string no_checks; ///< names of checks, separated by commas
};
void add_occam(Options&, OccamOptions&);

/// Returns the options for the code of a netlist's processes. Throws UserError for a check of the text, which a netlist
/// cannot leave out, and for an unknown one.
CompileChoices choices_of(const OccamOptions&);

/// Returns whether a file is a program in occam, by its name.
bool is_occam(const std::filesystem::path&);

/// Reads and checks a program, with libraries of ours and with files from these folders. Prints warnings to standard
/// error, and returns the name of the main procedure; "" if there is none. Throws RefusedInput.
std::string check_occam(const std::filesystem::path&, std::span<const std::string> folders, const OccamOptions&);

struct CompiledOccam {
    std::vector<std::uint8_t> file; ///< a bootable file
    std::string lines;              ///< a table of its code, for a file NAME.lines beside it
    std::uint64_t memory_bytes = 0; ///< that the program needs, with the free memory that it gets
};
/// Compiles a program for a transputer. Prints warnings to standard error. Throws
/// RefusedInput; throws UserError for an unknown check.
CompiledOccam compile_occam(const std::filesystem::path&, std::span<const std::string> folders, const OccamOptions&,
                            transputer::Model);

} // namespace placedpar
