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

/// Describes the program of a process in occam: a procedure in a file.
struct ProgramOfProcess {
    std::string path; ///< path of the file
    const Program* program = nullptr;
    const Declaration* procedure = nullptr;
};

/// Returns the program of a process.
using ProgramOf = std::function<ProgramOfProcess(const ProcessInstance&)>;

/// Holds the channels of processes in occam that use the wires of one node. A shared wire carries several channels in
/// one of its directions.
struct NodeRoutes {
    /// Describes a channel that passes through the node from one wire to another, neither of which is shared.
    struct Relay {
        CarriedChannel channel;
        int out; ///< number of the link by which the channel leaves the node
    };
    std::map<std::size_t, SharedWire> shared; ///< shared wires of the node; key: index in Network::connections
    std::vector<Relay> relays;
    std::vector<CarriedChannel> passing;  ///< all channels that neither begin nor end on the node
    std::map<std::size_t, int> addresses; ///< for each channel on an unshared wire: the word of memory of its link;
                                          ///< key: index in Network::channels
};

/// Returns the channels over the wires of a node. Throws UserError if a wire cannot carry its channels.
NodeRoutes ways_over(const Network&, std::size_t node, const ProgramOf&);

} // namespace placedpar::occam
