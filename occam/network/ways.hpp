#pragma once

#include "netlist/network/network.hpp"
#include "occam/language/tree.hpp"
#include "occam/network/multiplexer.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Describes the procedure of a file that is the program of a process.
struct ProgramOfProcess {
    std::string path; ///< path of the file
    const Program* program = nullptr;
    const Declaration* procedure = nullptr;
};

/// Returns the program of a process.
using ProgramOf = std::function<ProgramOfProcess(const ProcessInstance&)>;

/// Holds the channels of processes that are code on the wires of one node.
struct NodeRoutes {
    /// Describes a channel that passes from one wire to another. Neither wire carries another channel in this
    /// direction.
    struct Relay {
        CarriedChannel channel;
        int out; ///< number of the link by which the channel leaves
    };
    std::map<std::size_t, SharedWire> shared; ///< shared wires of the node; key: connection
    std::vector<Relay> relays;
    std::vector<CarriedChannel> passing;  ///< channels that neither begin nor end on the node
    std::map<std::size_t, int> addresses; ///< key: channel that is placed at a link; value: memory word of the link
};

/// Returns the channels over the wires of a node. Throws UserError if a wire cannot carry its channels.
NodeRoutes ways_over(const Network&, std::size_t node, const ProgramOf&);

} // namespace placedpar::occam
