#pragma once

#include <string>

namespace placedpar {

/// These functions draw block diagrams after the thesis's text, as SVG. Each call returns the same bytes.

/// Draws Figure 3.4: how the genetic algorithm gets its input from the pressure, the angle, and the spool or the
/// voltage.
std::string draw_figure_3_4();
/// Draws Figure 3.7: the excavator, the identification from one motion, and the simulator driven by another motion.
std::string draw_figure_3_7();

} // namespace placedpar
