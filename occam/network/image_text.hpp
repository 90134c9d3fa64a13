#pragma once

#include "netlist/network/network.hpp"
#include "occam/network/ways.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Holds the program of a node, and the names for reports.
struct TextOfImage {
    std::string text;
    std::vector<Component>
        components; ///< components of the program's PARs in the order of the text; their texts are empty
    std::map<std::string, std::string> channels; ///< names of channels in the network; key: name in the text
    bool carries = false; ///< the program has components of high priority that carry messages and never end
};

/// Returns a program in occam with all processes on a node that are code. The program is a PAR of instances of their
/// procedures. It has the channels between these processes, and channels that are placed at the links of the node; a
/// channel to the host is placed at the host's link. It also has processes that carry messages over shared wires, and
/// from wire to wire. Throws UserError if the processes cannot be joined to one program.
TextOfImage text_of_image(const Network&, std::size_t node, const ProgramOf&);

} // namespace placedpar::occam
