#pragma once

#include "explore/generate/topology_request.hpp"

#include <string>
#include <vector>

namespace placedpar::generate {

/// One end of a wire, described by expressions of the netlist language.
struct WireEnd {
    std::string at;   ///< subscripts of the processor at this end, "[r][c + 1]"
    std::string link; ///< number of the link, "1"
    std::string port; ///< subscript of the port to this neighbour; the ports of a process are numbered 0, 1, 2
                      ///< ...; "" if another wire leads to the same neighbour, whose port it is
};

/// A group of wires, one for each iteration of the loops.
struct Wires {
    std::vector<std::string> loops; ///< "rep r = 0 for rows", the outermost first
    WireEnd from, to;
    std::string name = ""; ///< name of the wire in a statement `connection`, which gives it attributes; "" for a wire
                           ///< without attributes
};

/// The wires from the workstation (node `sun`) to the processors of a topology.
struct HostWires {
    std::string loop = "";  ///< "" if there is only one wire
    std::string sun = "0";  ///< number of the workstation's link
    std::string at = "[0]"; ///< subscripts of the processor
    std::string link = "0"; ///< number of the processor's link, an expression such as "dimensions"
};

/// A topology of a given size, as fragments of the netlist language that declare and connect the array `t` of
/// processors. The fragments depend on constants (`vals`), so that --set can change the size. By default processors
/// have one subscript, and a wire leads from the first processor to the host.
struct Topology {
    std::string about;             ///< "A ring of 8 processors"
    std::vector<std::string> vals; ///< statements such as "val rows 4;"; one declares `nodes`, the number of processors
    std::string array = "[nodes]"; ///< dimensions with which `t` is declared, "[rows][columns]"
    std::string first = "[0]";     ///< subscripts of processor number 0, "[0][0]"
    std::string at = "[i]";        ///< subscripts of processor number i, "[i / columns][i % columns]"
    std::vector<Wires> wires = {};
    HostWires host = {};
    std::string no_host = "";    ///< why no link is free for a wire to the host; "" if a link is free
    std::size_t nodes = 0;       ///< number of processors
    std::string type = "T800";   ///< type of the processors
    std::string attributes = ""; ///< statements with attributes of single processors and wires; lines with a newline
};

std::vector<std::string> names_of_topologies();

/// Throws UserError if the topology is unknown or cannot have this size, or if a processor would need more links than a
/// transputer has.
Topology topology_of(const TopologyRequest&);

} // namespace placedpar::generate
