#pragma once

#include "picture/plot.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// Names the edge of a panel at which a series is cut off.
enum class PanelEdge : unsigned char { top, bottom, left, right };

struct CutOff {
    PanelEdge edge;
    double farthest; ///< farthest value of the series beyond the edge, in the axis's unit
    std::vector<double>
        places; ///< points on the edge where the series leaves the panel, or enters it after beginning beyond the edge
};

/// Returns where the given ends of the panel's axes cut the series off, in the order of the edges. Ignores points
/// beyond the ends of the other axis, and points so near to the edge that the difference is invisible.
std::vector<CutOff> cut_offs(const Series& series, const Panel& panel);

/// Returns a text for people such as " ↑ to 164 ← to -47"; empty for a series that is drawn whole.
std::string text_of(const std::vector<CutOff>& cut_offs);

} // namespace placedpar
