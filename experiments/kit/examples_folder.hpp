#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// Returns the folder of the examples: the first of these three folders that exists. 1. The folder that the environment
/// variable `PLACEDPAR_EXAMPLES` names. 2. `../share/placedpar/examples`, relative to the folder of an installed
/// program. 3. The folder named in `examples-folder.txt`, which the build writes beside a built program. Throws
/// UserError with the places searched if none of the folders exists.
std::filesystem::path examples_folder();

/// Returns the folder of the examples for the given program. `named` is the value of `PLACEDPAR_EXAMPLES`, or null.
std::filesystem::path examples_folder(const std::filesystem::path& program, const char* named);

} // namespace placedpar
