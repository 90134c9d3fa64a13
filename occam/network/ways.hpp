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

/// A procedure of a file, as the program of a process.
struct ProgramOfProcess {
    std::string path; ///< of the file
    const Program* program = nullptr;
    const Declaration* procedure = nullptr;
};

/// Returns the program of a process.
using ProgramOf = std::function<ProgramOfProcess(const ProcessInstance&)>;

/// The channels of code that lead over wires of a node.
struct NodeRoutes {
    /// A channel that passes from a wire to another one, which both carry nothing else in its direction.
    struct Relay {
        CarriedChannel channel;
        int out; ///< number of the link by which it leaves
    };
    std::map<std::size_t, SharedWire> shared; ///< by connection
    std::vector<Relay> relays;
    std::vector<CarriedChannel> passing;  ///< channels that neither begin nor end on the node
    std::map<std::size_t, int> addresses; ///< by channel: the word of memory of a channel that is placed at a link
};

/// Returns the ways over a node. Throws UserError if a wire cannot carry its channels.
NodeRoutes ways_over(const Network&, std::size_t node, const ProgramOf&);

} // namespace placedpar::occam
