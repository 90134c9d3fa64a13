#pragma once

#include "explore/generate/topology.hpp"

#include <string>
#include <vector>

namespace placedpar::generate {

/// Returns the statements of the netlist language inside these loops, indented one level for each loop. Every line ends
/// with a newline.
std::string within(const std::vector<std::string>& loops, const std::vector<std::string>& statements);

/// Returns `connect t[i].link[2] to t[i + 1].link[1];`, inside its loops, for every group of wires of the topology.
std::string print_wires(const Topology&);

/// Returns the statements that connect the processes at both ends of every wire by two channels, one in each direction.
/// The channels join processes of the array `process`, which has the same subscripts as `t`.
std::string print_channels(const Topology&, const std::string& process, const std::string& output,
                           const std::string& input);

} // namespace placedpar::generate
