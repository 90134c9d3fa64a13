#pragma once

#include <string>

namespace placedpar {

/// These functions draw block diagrams after the thesis's text, as SVG with the same bytes each time.

/// Draws Figure 3.4: how measured pressure, angle and spool or voltage become the input of the genetic algorithm.
std::string draw_figure_3_4();
/// Draws Figure 3.7: the excavator, the identification from one motion, and the simulator driven by another.
std::string draw_figure_3_7();

} // namespace placedpar
