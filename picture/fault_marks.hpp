#pragma once

#include "netlist/network/network.hpp"
#include "picture/picture.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::picture {

/// A fault of the network, at what it strikes.
struct FaultMark {
    std::optional<std::size_t> wire, node; ///< one of them
    std::string text;                      ///< "silent from 20 ms"
    std::string statement;                 ///< "t[0].link[1] silent (from = 20ms)"
    Box box;                               ///< of the text, beside it
};

/// In the order of the network's faults. The texts lie on no box or label, and on none of each other, where there is
/// room.
std::vector<FaultMark> fault_marks(const Network&, const Picture&);

} // namespace placedpar::picture
