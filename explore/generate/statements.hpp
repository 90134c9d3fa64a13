#pragma once

#include "explore/generate/topology.hpp"

#include <string>
#include <vector>

namespace placedpar::generate {

/// Returns the statements inside the loops, indented one level for each loop, with a newline at the end of every line.
std::string within(const std::vector<std::string>& loops, const std::vector<std::string>& statements);

/// Returns `connect t[i].link[2] to t[i + 1].link[1];`, in its loops, for every wire of the topology.
std::string print_wires(const Topology&);

/// Returns the declarations of a channel in each direction of every wire, between the processes of an array that has
/// the subscripts of t.
std::string print_channels(const Topology&, const std::string& process, const std::string& output,
                           const std::string& input);

} // namespace placedpar::generate
