#pragma once

#include "netlist/network/network.hpp"
#include "picture/picture.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::picture {

/// The mark for a simulated fault of the machine, at the wire or the node that the fault affects.
struct FaultMark {
    std::optional<std::size_t> wire, node; ///< one of the two is set
    std::string text;                      ///< such as "silent from 20 ms"
    std::string statement;                 ///< such as "t[0].link[1] silent (from = 20ms)"
    Box box;                               ///< box of the text
};

/// Returns the marks in the order of the network's faults. If there is room, the texts do not overlap boxes, labels or
/// each other.
std::vector<FaultMark> fault_marks(const Network&, const Picture&);

} // namespace placedpar::picture
