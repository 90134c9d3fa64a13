#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The slaves of a master, as a netlist connects them: a chain, a star, or any other tree.
struct SlaveTree {
    /// The slaves' processes, depth first: a slave, then all slaves behind its first channel, then all slaves behind
    /// its second channel.
    std::vector<std::size_t> slaves;
    std::size_t others = 0; ///< number of processes of other kinds that receive tasks; the slaves behind them are
                            ///< unknown
    std::vector<Complaint> complaints;
};

/// Follows the channels of tasks from a master, also through a ga.pipeline to slaves that several masters share.
/// Reports ports that are not numbered from 0 on, and a slave that is reached twice. Reports a slave whose results do
/// not return to the sender of its tasks, and results from a process that receives no tasks. Stops following a channel
/// at its first error.
SlaveTree follow_slaves(const Network&, std::size_t master);

/// Returns how many slaves a master or a slave has behind each of its channels to slaves, except for the last channel.
/// A process that is neither a slave nor a pipeline counts as one slave. REQUIRES: follow_slaves() reports no
/// complaints.
std::vector<std::size_t> count_slaves_behind(const Network&, std::size_t process);

/// Returns the slaves that form a circle with this slave. No master's tasks can reach them. Empty if the slave is not
/// in a circle.
std::vector<std::size_t> circle_of(const Network&, std::size_t slave);

} // namespace placedpar
