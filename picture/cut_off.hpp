#pragma once

#include "picture/plot.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// The edge of a panel (a diagram) at which a series of points is cut off, because it continues beyond the end of the
/// axis.
enum class PanelEdge : unsigned char { top, bottom, left, right };

struct CutOff {
    PanelEdge edge;
    double farthest;            ///< the value of the series that is farthest beyond the edge, in the axis's unit
    std::vector<double> places; ///< positions along the edge at which the series leaves the panel. If the series begins
                                ///< beyond the edge, also the position at which it enters
};

/// Returns the edges at which the panel's axes, as far as their ends are given, cut off the series. Ignores points
/// beyond the ends of the other axis, and points so little beyond the edge that the difference is invisible.
std::vector<CutOff> cut_offs(const Series& series, const Panel& panel);

/// Returns a text such as " ↑ to 164 ← to -47"; empty if the series is drawn completely.
std::string text_of(const std::vector<CutOff>& cut_offs);

} // namespace placedpar
