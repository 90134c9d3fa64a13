#pragma once

#include "picture/boxes.hpp"
#include "picture/labels.hpp"
#include "picture/raster.hpp"
#include "picture/wiring.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::picture {

/// Describes a label at the end of a wire, such as the number of its link.
struct LinkLabel {
    Box box;
    std::string text;
};

/// Counts the channels over a wire in each direction: right or down, left or up.
struct ChannelCount {
    Box box;
    std::size_t onward = 0, back = 0;
    bool upright = false; ///< the directions are down and up, not right and left
};

inline constexpr double digit_width = 6.5, arrow_width = 9;

/// Returns the width of the text, in pixels. A direction without channels is left out of the text.
double width_of_count(std::size_t onward, std::size_t back);

/// Describes a drawn wire and its labels. A label for which there is no room is left out.
struct DrawnWire {
    std::vector<Path> spans; ///< in order from the wire's a to its b
    std::vector<LinkLabel> links;
    std::optional<ChannelCount> channels;
};

/// Draws the wires of the network between the boxes of its nodes: straight if no box is in between, otherwise around
/// the boxes. A wire that joins the two ends of a row or column leaves the row or column at its ends.
std::vector<DrawnWire> draw_wires(const Network&, const std::vector<Span>&, const std::vector<DrawnNode>&);

} // namespace placedpar::picture
