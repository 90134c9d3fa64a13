#pragma once

#include "app/options.hpp"
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

/// Returns whether a file is a program in occam, by its name.
bool is_occam(const std::filesystem::path&);

/// Reads and checks a program, with libraries of ours and with files from these folders. Prints warnings to standard
/// error, and returns the name of the main procedure; "" if there is none. Throws RefusedInput.
std::string check_occam(const std::filesystem::path&, std::span<const std::string> folders, const OccamOptions&);

struct CompiledOccam {
    std::vector<std::uint8_t> file; ///< a bootable file
    std::string lines;              ///< a table of its code, for a file NAME.lines beside it
    std::uint64_t bytes = 0;        ///< of memory that it needs, from the start of memory
};
/// Compiles a program for a transputer. Prints warnings to standard error. Throws
/// RefusedInput; throws UserError for an unknown check.
CompiledOccam compile_occam(const std::filesystem::path&, std::span<const std::string> folders, const OccamOptions&,
                            transputer::Model);

} // namespace placedpar
