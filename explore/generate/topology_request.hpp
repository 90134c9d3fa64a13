#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace placedpar::generate {

/// The options that describe the wanted machine, as typed by the user.
struct TopologyRequest {
    std::string topology;                ///< one of names_of_topologies(), or a file with a graph
    std::string size;                    ///< "8" (processors), or "4x4" (rows and columns); "" for a file
    bool split = false;                  ///< whether a node of more than four edges is built from two processors
    std::optional<std::size_t> branches; ///< number of branches of each node of a tree
    std::optional<std::size_t> chord;    ///< length of the chords of a chordal ring, in processors
    std::optional<std::size_t> degree;   ///< number of links of each processor in a chordal ring: 3 or 4
    /// The processes: "farm", "islands", or a kind of process, of which one runs on every processor.
    std::string job = "islands";
    std::string problem; ///< search problem, such as "rastrigin(dimensions = 10)"; "": the default
    /// Where the host's process runs: "workstation", or "node" for the first processor.
    std::string host = "workstation";
    std::string output = "to_neighbours", input = "from_neighbours"; ///< names of the kind's port arrays
};

/// Number of links of a transputer.
inline constexpr std::size_t links_of_a_node = 4;

/// Largest number of processors of a generated netlist.
inline constexpr std::size_t most_processors = 4096;

} // namespace placedpar::generate
