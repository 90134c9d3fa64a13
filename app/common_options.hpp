#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace placedpar {

/// For CLI::Option::check: digits only, and a number that 64 bits hold. CLI11 itself takes -1 and what is too large
/// for the greatest such number, and 010 for eight.
std::string not_a_whole_number(const std::string& text);

/// --seed, of every random stream.
void add_seed(CLI::App&, std::uint64_t& seed);

/// An option that names a file to write, which cannot be "".
void add_output(CLI::App&, const std::string& option, std::string& path, const std::string& about);

} // namespace placedpar
