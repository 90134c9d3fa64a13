#pragma once

#include "app/exit_code.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace placedpar {

/// `placedpar replay`. An empty path writes no JSON. Throws std::runtime_error for an unknown experiment and
/// for examples that are not found.
ExitCode replay(const std::string& experiment, std::uint64_t seed, const std::filesystem::path& json,
                const std::string& command);

/// The names of the experiments, one a line, with what they are.
std::string list_experiments();

} // namespace placedpar
