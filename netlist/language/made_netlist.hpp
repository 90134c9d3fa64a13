#pragma once

#include "netlist/network/value.hpp"
#include "text/reporter.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// Says where a part of a made text comes from in the original file. The part extends to the next part.
struct PartOrigin {
    std::size_t offset = 0; ///< offset of the first character of the part
    Location place;
};

/// Holds a netlist that was made from a configuration in another language.
struct MadeNetlist {
    std::shared_ptr<const SourceFile> text; ///< null if the original text is a netlist itself, or has errors
    std::vector<PartOrigin> origins;        ///< in ascending order of offset; the first has offset 0
    std::vector<std::string> paths;         ///< paths of the files from which it was made, except the main file
    /// Writes a hint in the other language. Null if the original text is a netlist itself.
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
