#pragma once

#include "netlist/network/network.hpp"
#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::picture {

/// The unit of the drawing's raster, in pixels: borders of boxes and wires that turn corners lie on it.
inline constexpr double pitch = 8;

/// Heights of letters, in pixels.
inline constexpr double name_size = 13, fact_size = 10, process_size = 11, kind_size = 9, number_size = 9;

/// Heights in a node's box, in pixels: its heading, and a line for a process.
inline constexpr double heading_height = 40, process_height = 16;

/// Returns the greatest width of the text in the fonts that a viewer may use, in pixels.
double width_of(const std::string& text, double size, bool bold = false);

struct ProcessLine {
    std::size_t process = 0;
    std::string name, kind; ///< shortened if very long
    Point at;               ///< begin of the name, on the base line of the letters
    double kind_at = 0;     ///< x at which the kind ends
};

struct DrawnNode {
    Box box;
    std::string name, facts; ///< facts: type, memory, clock
    std::vector<ProcessLine> processes;
    std::string inside; ///< text with the number of channels within the node; "" if there are none
};

/// Draws the nodes as boxes that have room for their texts, at the given places in cells. Boxes do not overlap, and
/// there is room for wires between them.
std::vector<DrawnNode> draw_nodes(const Network&, const std::vector<Span>&, const std::vector<Point>& places);

} // namespace placedpar::picture
