#pragma once

#include <string>

namespace placedpar {

struct Plot; // picture/plot.hpp

/// Draws the plot as draw_svg() does, but with dates at the x axes. The values of x are seconds since 1970. REQUIRES:
/// each x axis has both ends.
std::string draw_svg_over_dates(const Plot&);

} // namespace placedpar
