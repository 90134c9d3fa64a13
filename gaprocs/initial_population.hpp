#pragma once

#include "gaprocs/representation/representation.hpp"

#include <filesystem>
#include <vector>

namespace placedpar {

/// The strings of a file, one in each line as Representation::read() takes it; empty lines and those that begin with
/// "#" do not count. Throws RefusedInput: a file that is not there or is not text, a line that is not a string of this
/// representation, which is shown.
std::vector<Genome> load_population(const std::filesystem::path& path, const Representation& representation);

} // namespace placedpar
