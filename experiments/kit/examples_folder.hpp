#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// Where the examples are: in the folder that the environment's PLACEDPAR_EXAMPLES names, in
/// ../share/placedpar/examples beside an installed program, or where the file examples-folder.txt says, which the build
/// writes beside its program and which is not installed. Throws UserError, naming where it looked.
std::filesystem::path examples_folder();

/// The same for another program and environment. `named`: PLACEDPAR_EXAMPLES; null where it is not set.
std::filesystem::path examples_folder(const std::filesystem::path& program, const char* named);

} // namespace placedpar
