#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// These functions return gnuplot commands for the room that a panel's axes need beside the curves.

/// Sets the variables Xfrom0 and Xto0, or those of the axis Y or of another panel, to the ends that gnuplot chose for
/// the axis when it drew the panel, or farther out if a series ends at the frame. Parts of a series that an axis cuts
/// off need no room. REQUIRES: gnuplot has just drawn the panel.
std::string room_commands(const Panel& panel, std::size_t number);

/// Sets the ends of an axis if all points have the same value, since gnuplot would then choose a range of only a
/// hundredth of this value.
Panel with_wide_axes(Panel panel);

/// Returns the x column of the data of the panel's series at `place`. x is moved slightly if another series has an
/// interval at the same x, so that no bar covers another. Uses the variables Xfrom0 and Xto0.
std::string column_of_x(const Panel& panel, std::size_t number, std::size_t place);

} // namespace placedpar
