#pragma once

#include "gaprocs/representation/representation.hpp"

#include <filesystem>
#include <vector>

namespace placedpar {

/// Reads the strings of a file. Each line holds a string in the form of Representation::read(); empty lines and lines
/// that begin with "#" are ignored. Throws RefusedInput if the file does not exist or is not text, or if a line is not
/// a string of this representation; the message shows the line.
std::vector<Genome> load_population(const std::filesystem::path& path, const Representation& representation);

} // namespace placedpar
