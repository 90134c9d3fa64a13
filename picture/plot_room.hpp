#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// Room that a panel's axes need beside what is drawn, in gnuplot's words.

/// Sets the variables Xfrom0 and Xto0, or those of the axis Y or of another panel, to the ends that gnuplot has given
/// to the axis when it drew the panel, but farther out where a series ends at the frame. What an axis cuts off needs no
/// room. REQUIRES: gnuplot has just drawn the panel.
std::string room_commands(const Panel& panel, std::size_t number);

/// The axes with ends of their own where all that is drawn is at one value, as gnuplot would show a hundredth of it.
Panel with_wide_axes(Panel panel);

/// The first column of the data of the panel's series at `place`, which is x: moved a little if another series has an
/// interval at the same x, so that no bar covers another. Uses the variables Xfrom0 and Xto0.
std::string column_of_x(const Panel& panel, std::size_t number, std::size_t place);

} // namespace placedpar
