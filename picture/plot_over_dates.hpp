#pragma once

#include <string>

namespace placedpar {

struct Plot; // picture/plot.hpp

/// Draws the plot as draw_svg() does, with dates at the x axes: x is in s since 1970. REQUIRES: each x axis has both
/// ends.
std::string draw_svg_over_dates(const Plot&);

} // namespace placedpar
