#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The slaves of a master, as a netlist connects them: a chain, a star, or any other tree.
struct SlaveTree {
    /// Processes, depth first: a slave, then all slaves behind its first channel to slaves, then those behind its
    /// second.
    std::vector<std::size_t> slaves;
    std::size_t others = 0; ///< processes of other kinds to which tasks are sent; the slaves behind them are not known
    std::vector<Complaint> complaints;
};

/// Follows the tasks from the master, also through a ga.pipeline to the slaves that the master shares. Reports
/// channels that are not numbered from 0 on, and a slave that is reached twice. Reports a slave whose results do not
/// return to the process that sends its tasks, and results from a process to which no tasks go. Does not follow the
/// tasks beyond such an error.
SlaveTree follow_slaves(const Network&, std::size_t master);

/// Returns how many slaves a master or a slave has behind each of its channels to slaves except the last. A process
/// that is neither slave nor pipeline counts as one. REQUIRES: follow_slaves() has no complaints.
std::vector<std::size_t> count_slaves_behind(const Network&, std::size_t process);

/// Returns the slaves that form a circle with this one, to which no master's tasks come; empty if the slave is not in a
/// circle.
std::vector<std::size_t> circle_of(const Network&, std::size_t slave);

} // namespace placedpar
