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

/// Tells from which place of the original file a part of a made text comes. The part extends to the beginning of the
/// next part.
struct PartOrigin {
    std::size_t offset = 0; ///< offset of the first character of the part
    Location place;
};

/// Holds a compiled program that boots a node.
struct CompiledProgram {
    std::shared_ptr<const std::vector<std::uint8_t>> bytes; ///< contents of a bootable file
    std::shared_ptr<const SourceFile> lines;                ///< the table of source lines; null if there is none
};
/// Holds compiled programs by the path that the netlist names. Paths that are not in this map are read from files.
using CompiledPrograms = std::map<std::string, CompiledProgram, std::less<>>;

/// Holds a netlist that was made from a configuration or a program in another language.
struct MadeNetlist {
    std::shared_ptr<const SourceFile> text = nullptr; ///< null if the original text is a netlist itself, or has errors
    std::vector<PartOrigin> origins = {};             ///< in ascending order of offset; the first has offset 0
    std::vector<std::string> paths = {}; ///< paths of the files from which the netlist was made, except the main file
    CompiledPrograms compiled = {};      ///< programs that replace bootable files
    /// Converts a hint in the netlist language to the other language. Null if the original text is a netlist itself.
    std::string (*translate_hint)(const std::string&) = nullptr;
};

/// Returns the value of a val: the value that an option sets, or the original value.
using ValChoice = std::function<Value(const std::string& name, const Value& original, const Location& at)>;

/// Makes a netlist from a file, which may include files from the folders. Reports the errors of the file. If the
/// ValChoice is empty, vals keep their values.
using NetlistMaker =
    std::function<MadeNetlist(const std::shared_ptr<const SourceFile>& file,
                              const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&)>;

} // namespace placedpar
