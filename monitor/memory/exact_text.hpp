#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// These functions write numbers and genomes as text, and read this text back to the same bits. The state file stores
/// numbers in this form, because a JSON parser may change the last bit of a double.

/// Writes each number in the shortest form that reads back exactly, separated by spaces.
std::string exact_text(std::span<const double> numbers);
/// Reads numbers that exact_text() has written. Throws std::runtime_error if the text has another form.
std::vector<double> numbers_from(std::string_view text);

/// Writes the number of bits per genome, then each genome in hexadecimal, separated by spaces. REQUIRES: all genomes
/// have the same size, at most 64 bits.
std::string exact_text(std::span<const Genome> strings);
/// Reads genomes that exact_text() has written. Throws std::runtime_error if the text has another form.
std::vector<Genome> genomes_from(std::string_view text);

} // namespace placedpar::monitor
