#pragma once

#include "explore/generate/topology.hpp"

namespace placedpar {
class Catalogue; // netlist/kinds/catalogue.hpp
} // namespace placedpar

namespace placedpar::generate {

/// Returns whether the topology is a file of a graph, whose name ends in .graphml, .dot or .gv.
bool is_graph_file(const std::string& topology);

/// Reads the file that the request names, and makes a machine of the graph. Each node becomes a processor, each edge a
/// wire. Two edges of a directed graph that join the same nodes in opposite directions become one wire. Attributes that
/// the netlist language has for a processor or a wire are copied. A comment in the generated netlist lists the names of
/// other attributes. A transputer has four links. With TopologyRequest::split, a node of five or six edges becomes two
/// processors. Throws UserError for any other node of more than four edges.
Topology topology_of_graph(const TopologyRequest&, const Catalogue&);

} // namespace placedpar::generate
