#pragma once

#include "gaprocs/coarse_fine.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// The pair of Figure 6.6 as it is set, as SVG: both searches with their populations, the strings that they breed,
/// field by field, above the problem's string, and what goes from one to the other. The same settings give the same
/// bytes. REQUIRES: a name for each field, without <, > and &.
std::string draw_pair(const CoarseFineSettings& settings, const std::vector<std::string>& fields);

} // namespace placedpar
