#pragma once

#include <filesystem>
#include <string>

namespace placedpar {

/// Returns the folder of the examples. It is the first of: the folder that the environment variable PLACEDPAR_EXAMPLES
/// names; ../share/placedpar/examples beside an installed program; the folder in the file examples-folder.txt, which
/// the build writes beside its program and which is not installed. Throws UserError, which names the places searched.
std::filesystem::path examples_folder();

/// Returns the same for another program and environment. `named` is the value of PLACEDPAR_EXAMPLES, or null.
std::filesystem::path examples_folder(const std::filesystem::path& program, const char* named);

} // namespace placedpar
