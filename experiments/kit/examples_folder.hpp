#pragma once

#include <filesystem>

namespace placedpar {

/// Where the examples are: in the folder that the environment's PLACEDPAR_EXAMPLES names, beside the
/// installed program in ../share/placedpar/examples, or in the source tree that it was built from.
/// Throws std::runtime_error, naming where it looked.
std::filesystem::path examples_folder();

} // namespace placedpar
