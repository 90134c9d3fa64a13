#pragma once

#include "explore/generate/topology.hpp"

#include <string>
#include <vector>

namespace placedpar::generate {

/// The loops around the statements, a level further in with each, and a newline at the end of every line.
std::string within(const std::vector<std::string>& loops, const std::vector<std::string>& statements);

/// `connect t[i].link[2] to t[i + 1].link[1];` in its loops, of all wires of the topology.
std::string print_wires(const Topology&);

/// A channel each way along every wire, between the processes of an array with the subscripts of t.
std::string print_channels(const Topology&, const std::string& process, const std::string& output,
                           const std::string& input);

} // namespace placedpar::generate
