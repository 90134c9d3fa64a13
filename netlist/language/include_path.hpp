#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A name as DOS has it, for this system: `\` separates folders.
std::string without_backslashes(std::string name);

/// Whether it names an include of the toolset's own: where there is none, what it declares is predefined.
bool is_of_the_toolset(const std::string& name);

/// The file of this name, in the first of the folders that has it. Where a folder has it in other letters, upper or
/// lower case, as DOS does not tell apart, that is the one; of several such the first by name.
std::optional<std::filesystem::path> find_included(const std::string& name,
                                                   const std::vector<std::filesystem::path>& folders);

} // namespace placedpar
