#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// Numbers and genomes as text from which the same bits are read back. A JSON parser's doubles may differ in the last.

/// Separated by blanks, each as short as it can be.
std::string exact_text(std::span<const double> numbers);
/// Throws std::runtime_error.
std::vector<double> numbers_from(std::string_view text);

/// How many bits each has, and each in hexadecimal, separated by blanks. REQUIRES: all of one size up to 64.
std::string exact_text(std::span<const Genome> strings);
/// Throws std::runtime_error.
std::vector<Genome> genomes_from(std::string_view text);

} // namespace placedpar::monitor
