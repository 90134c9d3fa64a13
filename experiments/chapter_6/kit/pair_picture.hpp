#pragma once

#include "gaprocs/coarse_fine.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Draws the pair of a coarse and a fine search (Figure 6.6) with these settings, as SVG. The picture shows both
/// searches with their populations and strings, the problem's string below, and the data that the searches exchange.
/// Strings are shown field by field (the bits of each parameter). The same settings give the same bytes. REQUIRES:
/// `fields` has a name for each field, without <, > and &.
std::string draw_pair(const CoarseFineSettings& settings, const std::vector<std::string>& fields);

} // namespace placedpar
