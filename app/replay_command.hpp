#pragma once

#include "app/exit_code.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace placedpar {

/// What the run leaves behind; nothing where a path is empty.
struct ReplayOutput {
    std::filesystem::path json;
    std::filesystem::path plots; ///< a folder, made when it is not there
};

/// `placedpar replay`. Throws std::runtime_error for an unknown experiment, for examples that are not found, and for
/// output that cannot be written.
ExitCode replay(const std::string& experiment, std::uint64_t seed, const ReplayOutput& output,
                const std::string& command);

/// The names of the experiments, one a line, with what they are.
std::string list_experiments();

} // namespace placedpar
