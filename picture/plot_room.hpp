#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// These functions leave room between the curves and the frame of a panel (a diagram), which gnuplot draws.

/// Returns commands that set the variables XfromN, XtoN, YfromN and YtoN for panel number N to the ends of its axes.
/// These are the ends that gnuplot chose when it drew the panel. If a series ends at the frame, the end of the axis is
/// moved farther out. Where an axis cuts off a series, no room is needed. REQUIRES: gnuplot has just drawn the panel.
std::string room_commands(const Panel& panel, std::size_t number);

/// Returns the panel, with ends set for each axis on which all values are equal. Without these ends, gnuplot would
/// choose a range of only a hundredth of the value.
Panel with_wide_axes(Panel panel);

/// Returns the gnuplot expression for x of the panel's series with index `place`. If another series has an interval at
/// the same x, the expression shifts x a little, so that no bar covers another. The expression uses the variables
/// XfromN and XtoN.
std::string column_of_x(const Panel& panel, std::size_t number, std::size_t place);

} // namespace placedpar
