#pragma once

#include "explore/study/study.hpp"

#include <string>

namespace placedpar {

/// Reads a study from a file of TOML: see docs/guides/studies.md. Paths in the file are relative to its folder. Throws
/// RefusedInput with the position of each error.
Study read_study(const std::string& path);

} // namespace placedpar
