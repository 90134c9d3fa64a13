#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// The slaves of a master as a netlist connects them: a chain, a star, or any other tree.
struct SlaveTree {
    /// Processes, depth first: a slave, then all behind its first channel to slaves, then those behind the second.
    std::vector<std::size_t> slaves;
    std::size_t others = 0; ///< processes of other kinds that tasks lead to; what is behind them is not known
    std::vector<Complaint> complaints;
};

/// Follows the tasks from the master on, through a ga.pipeline to the slaves that it shares. Complains of channels that
/// are not numbered from 0 on, of a slave that is reached twice or whose results do not return the way that its tasks
/// come, and of results from where no tasks go; what is beyond is not followed.
SlaveTree follow_slaves(const Network&, std::size_t master);

/// How many slaves a master or a slave has behind each of its channels to slaves but the last. What is neither
/// slave nor pipeline counts as one. REQUIRES: follow_slaves complains of nothing.
std::vector<std::size_t> count_slaves_behind(const Network&, std::size_t process);

/// The slaves that pass their tasks on in a circle with this one, which no master reaches; none where it is in none.
std::vector<std::size_t> circle_of(const Network&, std::size_t slave);

} // namespace placedpar
