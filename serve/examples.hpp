#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace placedpar::serve {

/// Texts by their paths below a folder, such as "csp/deadlock/deadlock.cfs".
using Texts = std::map<std::string, std::string>;

/// Reads the examples that the web page offers: the netlists, configurations and programs in occam in the folder, and
/// the files that they include.
Texts read_examples(const std::filesystem::path& folder);

} // namespace placedpar::serve
