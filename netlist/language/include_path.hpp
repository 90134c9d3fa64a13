#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Converts the path of a DOS file, in which `\` separates folders, to a path for this system. Netlists for INMOS's
/// tools have such paths.
std::string without_backslashes(std::string name);

/// Returns whether this is the name of an include file of INMOS's toolset. What such a file declares is predefined, so
/// that the file need not exist.
bool is_of_the_toolset(const std::string& name);

/// Returns the file of this name in the first folder that has such a file; nothing if no folder has one. If no file in
/// a folder has exactly this name, names that differ only in upper and lower case count, too, as in DOS. If several
/// such names match, returns the file whose name is the first in order.
std::optional<std::filesystem::path> find_included(const std::string& name,
                                                   const std::vector<std::filesystem::path>& folders);

} // namespace placedpar
