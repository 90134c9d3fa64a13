#pragma once

#include "explore/study/study.hpp"

#include <string>

namespace placedpar {

/// Reads a study from a file of TOML: see docs/guides/studies.md. Paths of its netlist and folders are relative to the
/// file. Throws RefusedInput with the position of each error.
Study read_study(const std::string& path);

} // namespace placedpar
