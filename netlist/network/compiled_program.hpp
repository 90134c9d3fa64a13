#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

class SourceFile; // text/source.hpp

/// Holds a compiled program that boots a node.
struct CompiledProgram {
    std::shared_ptr<const std::vector<std::uint8_t>> bytes; ///< contents of a bootable file
    std::shared_ptr<const SourceFile> lines;                ///< the table of source lines; null if there is none
};
/// Holds compiled programs by the path that the netlist names. Paths that are not in this map are read from files.
using CompiledPrograms = std::map<std::string, CompiledProgram, std::less<>>;

} // namespace placedpar
