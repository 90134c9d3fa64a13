#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// Returns the folder of the examples: the first folder that exists of the following. 1. The folder that the
/// environment variable `PLACEDPAR_EXAMPLES` names. 2. For an installed program, `../share/placedpar/examples` beside
/// the program's folder. 3. For a built program, the folder named in `examples-folder.txt`, which the build writes
/// beside the program. Throws UserError with the places searched if none exists.
std::filesystem::path examples_folder();

/// Does the same for the given program. `named` is the value of `PLACEDPAR_EXAMPLES`, or null.
std::filesystem::path examples_folder(const std::filesystem::path& program, const char* named);

} // namespace placedpar
