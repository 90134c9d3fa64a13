#pragma once

#include "picture/plot.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// The end of an axis beyond which a series goes, so that it is cut off there.
enum class PanelEdge : unsigned char { top, bottom, left, right };

struct CutOff {
    PanelEdge edge;
    double farthest;            ///< how far it goes there, in the axis's unit
    std::vector<double> places; ///< on the edge, where it leaves, or where it comes in if it begins beyond
};

/// Where the ends that the panel's axes are given cut a series off, by edges in their order. What lies beyond the ends
/// of the other axis does not count, nor does what is beyond by less than can be seen.
std::vector<CutOff> cut_offs(const Series& series, const Panel& panel);

/// For people: " ↑ to 164 ← to -47"; empty for a series that is drawn whole.
std::string text_of(const std::vector<CutOff>& cut_offs);

} // namespace placedpar
