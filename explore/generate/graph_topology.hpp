#pragma once

#include "explore/generate/topology.hpp"

namespace placedpar {
class Catalogue; // netlist/kinds/catalogue.hpp
} // namespace placedpar

namespace placedpar::generate {

/// Returns whether the topology is the name of a file with a graph: .graphml, .dot or .gv.
bool is_graph_file(const std::string& topology);

/// Reads the file that the request names. Each node becomes a processor, each edge a wire; two edges of a directed
/// graph that join the same nodes in opposite directions are one wire. Attributes that the netlist language has for
/// a processor or a wire are copied. A comment in the generated netlist lists the names of other attributes. Throws
/// UserError if a node has more edges than a transputer has links, unless the request splits nodes and the node has at
/// most six edges.
Topology topology_of_graph(const TopologyRequest&, const Catalogue&);

} // namespace placedpar::generate
