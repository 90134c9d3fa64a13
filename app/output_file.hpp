#pragma once

#include <filesystem>
#include <string_view>

namespace placedpar {

/// Writes a file whole or not at all: to a temporary file beside it, which then takes its name.
/// Throws std::runtime_error, naming the file and the reason.
void write_whole(const std::filesystem::path&, std::string_view content);

/// Throws std::runtime_error if write_whole to this path is sure to fail, so that a long run is not lost.
void require_writable(const std::filesystem::path&);

} // namespace placedpar
