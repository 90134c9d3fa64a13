#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Converts the name of a DOS file, in which `\` separates folders, to a name for this system.
std::string without_backslashes(std::string name);

/// Returns whether this is the name of an include file of the INMOS toolset. The declarations
/// in such files are predefined, so the file need not exist.
bool is_of_the_toolset(const std::string& name);

/// Returns the file of this name in the first folder that has such a file. If no file of a folder has exactly this
/// name, the case of letters is ignored in this folder, as in DOS. If several files then match, returns the first in
/// order of names.
std::optional<std::filesystem::path> find_included(const std::string& name,
                                                   const std::vector<std::filesystem::path>& folders);

} // namespace placedpar
