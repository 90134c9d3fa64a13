#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Converts a DOS file name for this system: `\` separates folders.
std::string without_backslashes(std::string name);

/// Returns whether the name is an include file of the INMOS toolset. The declarations of a missing toolset file are
/// predefined.
bool is_of_the_toolset(const std::string& name);

/// Returns the file of this name in the first folder that has it. If a folder does not have the exact name, the case of
/// letters is ignored in this folder, as in DOS. If several files then match, returns the first in order of names.
std::optional<std::filesystem::path> find_included(const std::string& name,
                                                   const std::vector<std::filesystem::path>& folders);

} // namespace placedpar
