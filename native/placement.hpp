#pragma once

#include "netlist/network/network.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::native {

/// The most threads of a native run: our choice, far above the number of cores of a computer.
inline constexpr std::size_t most_threads = 1024;

/// The threads or MPI ranks on which a network can be placed.
struct Places {
    std::size_t count = 1;         ///< at least 1
    std::string noun = "thread";   ///< for messages
    std::string how = "--threads"; ///< how a user states the count
    std::size_t most = most_threads;
};

/// Returns the number of places that can have processes: one for each node with processes, or more if the netlist gives
/// higher ranks to nodes.
std::size_t most_places(const Network&);

/// Throws UserError if mpirun has started more ranks than the network can use.
void require_enough_nodes(const Network&, std::size_t ranks);

/// Returns the place of each node; 0 for a node without processes. A node with the attribute `rank` is on the place of
/// this number. The places of the other nodes depend on the loads:
///
/// - Without loads, the nodes that have processes are numbered from 0, and node i is on place i modulo the number of
///   places.
/// - With loads, one for each node, the nodes are assigned in descending order of load, each to the place with the
///   least load so far (longest processing time first: R. L. Graham, Bounds on multiprocessing timing anomalies, SIAM
///   Journal on Applied Mathematics 17, 1969). Among places of equal load, the place with the fewest nodes is taken;
///   among these, the first.
///
/// Throws UserError if a node with processes has a rank that is not a place. REQUIRES: no load is negative.
std::vector<std::size_t> place_nodes(const Network&, const Places&, const std::vector<Time>& loads = {});

} // namespace placedpar::native
