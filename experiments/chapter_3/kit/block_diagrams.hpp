#pragma once

#include <string>

namespace placedpar {

/// These functions draw block diagrams of the thesis as SVG. Every call of a function returns the same bytes.

/// Draws Figure 3.4: how the input of the genetic algorithm is computed from the pressure, the angle, and the spool or
/// the voltage.
std::string draw_figure_3_4();
/// Draws Figure 3.7: the excavator, the identification (the search for its compliances) from one motion, and the
/// simulator that checks the result with another motion.
std::string draw_figure_3_7();

} // namespace placedpar
