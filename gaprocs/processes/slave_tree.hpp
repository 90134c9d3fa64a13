#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The slaves of a master, as a netlist connects them: a chain, a star, or any other tree.
struct SlaveTree {
    /// Indices of the slaves in Network::processes, depth first: a slave, then all slaves behind its first channel,
    /// then all slaves behind its second channel, and so on.
    std::vector<std::size_t> slaves;
    std::size_t others = 0; ///< number of processes that receive tasks, but are neither ga.slave nor ga.pipeline;
                            ///< slaves behind them are not found
    std::vector<Complaint> complaints;
};

/// Follows the channels of tasks from a master, also through a ga.pipeline, which passes tasks of several masters to
/// the same slaves. Complains about ports that are not numbered 0, 1, 2, ..., and about a slave that is reached twice.
/// Complains about a slave whose results do not go to the process that sends its tasks, and about results from a
/// process that receives no tasks. Stops following a channel at the first error.
SlaveTree follow_slaves(const Network&, std::size_t master);

/// Returns the number of slaves behind each channel of a master or a slave, except the last channel. A process that is
/// neither a slave nor a pipeline counts as one slave. REQUIRES: follow_slaves() reports no complaints.
std::vector<std::size_t> count_slaves_behind(const Network&, std::size_t process);

/// Returns the slaves of the circle to which this slave belongs; empty if the slave is not in a circle. Such a slave
/// would wait for ever, because no master's tasks reach it.
std::vector<std::size_t> circle_of(const Network&, std::size_t slave);

} // namespace placedpar
