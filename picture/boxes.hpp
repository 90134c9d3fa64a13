#pragma once

#include "netlist/network/network.hpp"
#include "picture/geometry.hpp"
#include "picture/wiring.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::picture {

/// The distance of neighbouring points of the drawing's raster, in pixels. The borders of boxes, and wires that turn
/// corners, lie on the raster.
inline constexpr double pitch = 8;

/// The heights of letters, in pixels.
inline constexpr double name_size = 13, fact_size = 10, process_size = 11, kind_size = 9, number_size = 9;

/// The heights, in pixels, of the heading of a node's box and of the line for a process.
inline constexpr double heading_height = 40, process_height = 16;

/// Returns an estimate of the text's width, in pixels, for the widest font that a viewer may use.
double width_of(const std::string& text, double size, bool bold = false);

struct ProcessLine {
    std::size_t process = 0;
    std::string name, kind; ///< shortened if very long
    Point at;               ///< start of the name, on the base line of the letters
    double kind_at = 0;     ///< x coordinate of the end of the kind's text
};

struct DrawnNode {
    Box box;
    std::string name, facts; ///< facts: type, memory, clock
    std::vector<ProcessLine> processes;
    std::string inside; ///< text that says how many channels are inside the node, or how the node boots; "" if there is
                        ///< nothing to say
};

/// Draws the nodes as boxes that have room for their texts, at the given places in cells. Boxes do not overlap, and
/// there is room for wires between them.
std::vector<DrawnNode> draw_nodes(const Network&, const std::vector<Span>&, const std::vector<Point>& places);

} // namespace placedpar::picture
