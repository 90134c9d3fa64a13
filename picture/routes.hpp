#pragma once

#include "picture/boxes.hpp"
#include "picture/labels.hpp"
#include "picture/raster.hpp"
#include "picture/wiring.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::picture {

/// A label at the end of a wire, such as the number of its link.
struct LinkLabel {
    Box box;
    std::string text;
};

/// The label of a wire with the numbers of channels that use the wire. `onward` channels lead to the right or down,
/// `back` channels to the left or up.
struct ChannelCount {
    Box box;
    std::size_t onward = 0, back = 0;
    bool upright = false; ///< true: down and up; false: right and left
};

inline constexpr double digit_width = 6.5, arrow_width = 9;

/// Returns the width of the text of a ChannelCount, in pixels. The text leaves out a direction without channels.
double width_of_count(std::size_t onward, std::size_t back);

/// A drawn wire and its labels. A label for which there is no room is left out.
struct DrawnWire {
    std::vector<Path> spans; ///< paths between the devices on the wire, in order from the wire's end `a` to its end `b`
    std::vector<LinkLabel> links;
    std::optional<ChannelCount> channels;
};

/// Draws the network's wires between the boxes of its nodes: straight if no box is in between, otherwise around the
/// boxes. A wire between the first and the last node of a row or column leaves these nodes at the outer ends of the row
/// or column.
std::vector<DrawnWire> draw_wires(const Network&, const std::vector<Span>&, const std::vector<DrawnNode>&);

} // namespace placedpar::picture
