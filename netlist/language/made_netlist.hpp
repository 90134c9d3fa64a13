#pragma once

#include "netlist/network/value.hpp"
#include "text/reporter.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// Tells from which place of an occam file a part of a netlist comes, if the netlist was made from this file. The part
/// extends to the beginning of the next part.
struct PartOrigin {
    std::size_t offset = 0; ///< offset of the first character of the part
    Location place;
};

/// Holds a program, compiled in memory, that boots a transputer.
struct CompiledProgram {
    std::shared_ptr<const std::vector<std::uint8_t>> bytes; ///< contents of a bootable file
    std::shared_ptr<const SourceFile> lines; ///< source line of each instruction, as text; null if there is none
};
/// Holds compiled programs by the paths that the netlist names. A path that is not in this map is read as a file.
using CompiledPrograms = std::map<std::string, CompiledProgram, std::less<>>;

/// Holds a netlist that was made from an occam configuration or program.
struct MadeNetlist {
    std::shared_ptr<const SourceFile> text = nullptr; ///< null if the original text is a netlist itself, or has errors
    std::vector<PartOrigin> origins = {};             ///< in ascending order of offset; the first has offset 0
    std::vector<std::string> paths = {}; ///< paths of the files from which the netlist was made, except the main file
    CompiledPrograms compiled = {};      ///< programs that are used in place of bootable files
    /// Converts a hint in the netlist language to the language of the original. Null if the original text is a netlist
    /// itself.
    std::string (*translate_hint)(const std::string&) = nullptr;
};

/// Returns the value of a constant (`VAL` in occam): the value that an option sets, or the original value.
using ValChoice = std::function<Value(const std::string& name, const Value& original, const Location& at)>;

/// Makes a netlist from a file in occam, which may include files from the folders. Reports the errors of the file. If
/// the ValChoice is empty, constants keep their original values.
using NetlistMaker =
    std::function<MadeNetlist(const std::shared_ptr<const SourceFile>& file,
                              const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&)>;

} // namespace placedpar
