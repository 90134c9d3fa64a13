#pragma once

#include "netlist/network/network.hpp"
#include "occam/network/ways.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Holds the program of a node as text in occam, and names for reports.
struct TextOfImage {
    std::string text;
    std::vector<Component>
        components; ///< the components of the program's PARs, in the order of `text`; their own member `text` is empty
    std::map<std::string, std::string> channels; ///< name of each channel in the network; key: its name in `text`
    bool carries = false; ///< the program has components that only pass on messages of other processes; they have high
                          ///< priority and never end
};

/// Returns one program in occam that runs all processes in occam on a node. The program is a PAR of instances of their
/// procedures. It declares the channels between these processes, and places the other channels at the links of the
/// node; a channel to the host is at the host's link. If several channels share a wire, or pass the node from one wire
/// to another, the program also has processes that pass on their messages. Throws UserError if the processes cannot be
/// joined to one program.
TextOfImage text_of_image(const Network&, std::size_t node, const ProgramOf&);

} // namespace placedpar::occam
