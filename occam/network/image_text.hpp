#pragma once

#include "netlist/network/network.hpp"
#include "occam/network/ways.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace placedpar::occam {

/// The program of a node, with the names that reports use.
struct TextOfImage {
    std::string text;
    std::vector<Component> components;           ///< of its PARs, in order of the text, without their texts
    std::map<std::string, std::string> channels; ///< names in the network, by those in the text
    bool carries = false;                        ///< components of high priority carry messages, and never end
};

/// Returns a program in occam that is all processes on a node that are code: a PAR of instances, with channels between
/// them, and with channels that are placed at the links of the node. A channel to the host is placed at its link. The
/// program also has the processes that carry messages over shared wires, and from wire to wire. Throws UserError if the
/// programs cannot be one.
TextOfImage text_of_image(const Network&, std::size_t node, const ProgramOf&);

} // namespace placedpar::occam
