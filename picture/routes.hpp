#pragma once

#include "picture/boxes.hpp"
#include "picture/labels.hpp"
#include "picture/raster.hpp"
#include "picture/wiring.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar::picture {

/// What stands at the end of a wire, as the number of its link.
struct LinkLabel {
    Box box;
    std::string text;
};

/// How many channels go which way over a wire: right or down, left or up.
struct ChannelCount {
    Box box;
    std::size_t onward = 0, back = 0;
    bool upright = false; ///< they go down and up, not right and left
};

inline constexpr double digit_width = 6.5, arrow_width = 9;

/// In pixels; a direction without channels is left out.
double width_of_count(std::size_t onward, std::size_t back);

/// A wire, with what stands at it. A label for which there is no room is left out.
struct DrawnWire {
    std::vector<Path> spans; ///< in order from the wire's a to its b
    std::vector<LinkLabel> links;
    std::optional<ChannelCount> channels;
};

/// The wires of the network between the boxes of its nodes: straight where nothing is between, around the boxes
/// elsewhere; a wire that closes a row or a column leaves it at its ends.
std::vector<DrawnWire> draw_wires(const Network&, const std::vector<Span>&, const std::vector<DrawnNode>&);

} // namespace placedpar::picture
