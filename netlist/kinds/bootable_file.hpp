#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Limits the size of a bootable file.
inline constexpr std::size_t largest_bootable_bytes = 64 * 1024 * 1024;

/// Returns why these bytes cannot boot a transputer, and which tools make bootable files; "" if the bytes can. Only the
/// contents of a file decide, since the names of bootable files vary: .btl, .b4h, .b8h, .bxx.
std::string why_not_bootable(std::span<const std::uint8_t> bytes);

/// Returns whether a file's contents are probably code for a transputer, and not a netlist or another text.
bool looks_bootable(const std::filesystem::path&);

/// Reads a bootable file. Throws UserError if it cannot be read or is not bootable: "hello.tah: ...".
std::vector<std::uint8_t> read_bootable(const std::filesystem::path&);

} // namespace placedpar
