#pragma once

#include <string>

namespace placedpar {

/// Block diagrams of the thesis, drawn after its text: SVG, the same bytes each time.

/// Figure 3.4: what the measured pressure, angle and spool or voltage become before the genetic algorithm takes them.
std::string draw_figure_3_4();
/// Figure 3.7: the excavator, the identification from one motion, and the simulator that is driven by another.
std::string draw_figure_3_7();

} // namespace placedpar
