#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// These functions return gnuplot commands that leave room between the curves and the frame of a panel.

/// Returns commands that set the variables XfromN, XtoN, YfromN and YtoN for panel number N to the ends of its axes.
/// Gnuplot chose these ends when it drew the panel; an end is moved farther out if a series ends at the frame. Parts of
/// a series that an axis cuts off need no room. REQUIRES: gnuplot has just drawn the panel.
std::string room_commands(const Panel& panel, std::size_t number);

/// Returns the panel, with ends set for each axis on which all values are equal. Without these ends, gnuplot would
/// choose a range of only a hundredth of the value.
Panel with_wide_axes(Panel panel);

/// Returns the x column of the data of the panel's series with index `place`. If another series has an interval at the
/// same x, x is shifted slightly, so that no bar covers another. The expression uses the variables XfromN and XtoN.
std::string column_of_x(const Panel& panel, std::size_t number, std::size_t place);

} // namespace placedpar
