#pragma once

#include "explore/load.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "netlist/network/network.hpp"
#include "occam/code/compile.hpp"
#include "occam/language/parse.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The choices with which occam is compiled.
struct OccamOptions {
    std::string mode = "halt";
    std::string no_checks = ""; ///< names of checks, separated by commas
};

/// Returns the options for the code of a netlist's processes. Throws UserError for an unknown check, and for the checks
/// "usage" and "alias", which a netlist cannot turn off for its programs.
CompileChoices choices_of(const OccamOptions&);

/// Returns the checks that these options do not turn off. Throws UserError for an unknown check.
occam::SourceOptions wanted_checks(const OccamOptions&);

/// Returns whether a file is a program in occam, by its name. A configuration is not a program.
bool is_occam(const std::filesystem::path&);

/// Returns whether `placedpar run` can run this procedure: its parameters are none, or channels to a host and perhaps
/// the free memory, or the channels of a terminal. REQUIRES: the program has no errors.
bool can_be_run(const occam::Declaration& procedure);

struct CompiledOccam {
    std::vector<std::uint8_t> file; ///< a bootable file
    std::string lines;              ///< for the file NAME.lines: the source line of each address
    std::uint64_t memory_bytes = 0; ///< memory that the program needs, including the free memory that it receives
};
/// Compiles a program for a transputer. Throws RefusedInput; throws UserError for an unknown check.
CompiledOccam compile_occam(const std::filesystem::path&, std::span<const std::string> folders, const OccamOptions&,
                            transputer::Model, const WarningSink&);

/// The transputer on which a program without a netlist runs.
struct ProgramMachine {
    std::string processor = "T800", memory = "2M"; ///< REQUIRES: `processor` is the name of a model, `memory` a size
    std::uint64_t memory_cycles = 3;
    OccamOptions occam = {};
};
/// Returns the number of bytes of a size such as 32K or 2M; nothing if the text is not a size.
std::optional<std::uint64_t> bytes_of_size(const std::string& text);
/// Returns a netlist with one transputer that the file boots. In mode stop, a process may read beyond the memory just
/// before it stops; the netlist makes such a read harmless.
std::string netlist_around(const std::filesystem::path& file, const ProgramMachine&);
/// Compiles a program for the machine. Throws as compile_occam(); throws UserError if the memory is too small.
CompiledProgram compiled_program(const std::filesystem::path&, std::span<const std::string> folders,
                                 const ProgramMachine&, const WarningSink&);

} // namespace placedpar
