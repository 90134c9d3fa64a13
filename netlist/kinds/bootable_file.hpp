#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Limits the size of a bootable file.
inline constexpr std::size_t largest_bootable_bytes = 64 * 1024 * 1024;

/// Returns the reason why these bytes, the contents of a file, cannot boot a transputer; "" if they can. The text also
/// names tools that make bootable files. The name of the file does not matter, since the names of bootable files vary:
/// .btl, .b4h, .b8h, .bxx.
std::string why_not_bootable(std::span<const std::uint8_t> bytes);

/// Returns whether the contents of a file are probably machine code, and not a netlist or another text.
bool looks_bootable(const std::filesystem::path&);

/// Reads a bootable file. Throws UserError if the file cannot be read or is not bootable.
std::vector<std::uint8_t> read_bootable(const std::filesystem::path&);

} // namespace placedpar
