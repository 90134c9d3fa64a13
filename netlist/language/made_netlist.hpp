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

/// The place that a part of a made text stands for. The part goes on to the next one.
struct PartOrigin {
    std::size_t offset = 0; ///< of the first character of the part
    Location place;
};

/// A netlist that was made of a text in another language of configurations.
struct MadeNetlist {
    std::shared_ptr<const SourceFile> text; ///< null if the other text is a netlist itself, or has errors
    std::vector<PartOrigin> origins;        ///< by offset; the first one has offset 0
    std::vector<std::string> paths;         ///< of the files that it was made of, without the main one
    /// Writes a hint in the other language. Null if the other text is a netlist itself.
    std::string (*translate_hint)(const std::string&) = nullptr;
};

/// Returns the value of a val: the original one, or the one that an option sets.
using ValChoice = std::function<Value(const std::string& name, const Value& original, const Location& at)>;

/// Makes a netlist of a file, which may include others from the folders. Reports the errors of the file. Without a
/// choice, vals keep their values.
using NetlistMaker =
    std::function<MadeNetlist(const std::shared_ptr<const SourceFile>& file,
                              const std::vector<std::filesystem::path>& folders, const ValChoice&, Reporter&)>;

} // namespace placedpar
