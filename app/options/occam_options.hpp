#pragma once

#include "app/options.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "occam/code/compile.hpp"
#include "occam/language/parse.hpp"

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

/// Returns the checks that the option --no-checks does not leave out. Throws UserError if it names an unknown one.
occam::SourceOptions wanted_checks(const OccamOptions&);

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
