#pragma once

#include "explore/load.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "netlist/language/made_netlist.hpp"
#include "netlist/network/network.hpp"
#include "occam/check/check.hpp"
#include "occam/code/compile.hpp"
#include "occam/language/parse.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
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

/// Returns whether `placedpar run` can run this procedure. Its parameters must be absent, the channels of a terminal,
/// or channels to a host, perhaps followed by the free memory. REQUIRES: the program has no errors.
bool can_be_run(const occam::Declaration& procedure);

struct CompiledOccam {
    std::vector<std::uint8_t> file; ///< a bootable file
    std::string lines;              ///< for the file NAME.lines: the source line of each address
    std::uint64_t memory_bytes = 0; ///< memory that the program needs, including the free memory that it receives
};
/// Compiles a program for a transputer. Throws RefusedInput; throws UserError for an unknown check.
CompiledOccam compile_occam(const std::filesystem::path&, const std::vector<std::filesystem::path>& folders,
                            const OccamOptions&, transputer::Model, const WarningSink&);

/// Compiles a program that can_be_run() for a T800, to find what only the compiler refuses. REQUIRES: the program has
/// no errors. Throws RefusedText.
void require_compilable(const std::shared_ptr<const SourceFile>&, const std::vector<std::filesystem::path>& folders,
                        const occam::SourceOptions& wanted);

/// The transputer on which a program without a netlist runs.
struct ProgramMachine {
    std::string processor = "T800", memory = "2M"; ///< REQUIRES: `processor` is the name of a model, `memory` a size
    std::uint64_t memory_cycles = 3;
    OccamOptions occam = {};
};
/// Returns the number of bytes of a size such as 32K or 2M; nothing if the text is not a size.
std::optional<std::uint64_t> bytes_of_size(const std::string& text);
/// Returns a netlist with one transputer that the file boots. In error mode "stop", a process may read beyond the
/// memory just before it stops. The netlist makes such a read harmless.
std::string netlist_around(const std::filesystem::path& file, const ProgramMachine&);
/// Returns a function that makes a netlist from a file in occam. A configuration becomes the netlist that it describes.
/// A program is compiled for the machine, and becomes a netlist with one transputer, which it boots. The option --set
/// can set the VALs at the outermost level of the file. For a program, the function throws UserError if the file has no
/// procedure that can be run, if the memory is too small, or for an unknown check.
NetlistMaker netlist_maker(const ProgramMachine&);
/// Throws UserError if the file is a program in occam. The network that netlist_maker() makes of a program cannot be
/// printed as a netlist that could be read again: a netlist names bootable files, but the program's code is only in
/// memory.
void require_netlist(const std::filesystem::path&);

} // namespace placedpar
