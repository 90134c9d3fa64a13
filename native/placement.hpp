#pragma once

#include "netlist/network/network.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::native {

/// The most threads of a native run (our choice, far above the number of cores of a computer).
inline constexpr std::size_t most_threads = 1024;

/// The threads of one program, or the ranks (copies of the program that mpirun started), that run the processes of a
/// network in real time.
struct Places {
    std::size_t count = 1;         ///< at least 1
    std::string noun = "thread";   ///< for messages
    std::string how = "--threads"; ///< the option by which a user states the count
    std::size_t most = most_threads;
};

/// Returns how many places a network can use: one for each node with processes, or more if the netlist gives nodes
/// higher ranks. A node is a processor of the netlist.
std::size_t most_places(const Network&);

/// Throws UserError if mpirun has started more ranks than the network can use.
void require_enough_nodes(const Network&, std::size_t ranks);

/// Returns the number of the place that runs the processes of each node; 0 for a node without processes. The netlist
/// can state the place of a node by the attribute `rank`. The places of the other nodes depend on their loads, that is,
/// on the computing times of their processes:
///
/// - Without loads, node i of the nodes with processes, counted from 0, is on place i modulo the number of places.
/// - With loads, one for each node, the nodes are assigned in descending order of load. Each node goes to the place
/// with the least load so far (longest processing time first: R. L. Graham, Bounds on multiprocessing timing anomalies,
/// SIAM Journal on Applied Mathematics 17, 1969). Among places of equal load, the place with the fewest nodes is taken;
/// if several have equally few, the first of them.
///
/// Throws UserError if the netlist states a place that does not exist. REQUIRES: no load is negative.
std::vector<std::size_t> place_nodes(const Network&, const Places&, const std::vector<Time>& loads = {});

} // namespace placedpar::native
