#pragma once

#include "gaprocs/coarse_fine.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Draws the pair of Figure 6.6 with these settings, as SVG. It shows both searches with their populations, their
/// strings, field by field, above the problem's string, and the data sent between them. The same settings give the same
/// bytes. REQUIRES: a name for each field, without <, > and &.
std::string draw_pair(const CoarseFineSettings& settings, const std::vector<std::string>& fields);

} // namespace placedpar
