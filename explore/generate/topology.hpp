#pragma once

#include "explore/generate/wish.hpp"

#include <string>
#include <vector>

namespace placedpar::generate {

/// One of the two ends of a wire, as expressions of the netlist language.
struct WireEnd {
    std::string at;   ///< the subscripts of its processor, "[r][c + 1]"
    std::string link; ///< its number, "1"
    std::string port; ///< which of its neighbours this one is to a process there: numbered 0, 1, 2 ... without a gap
};

/// Wires, one for each round of the loops.
struct Wires {
    std::vector<std::string> loops; ///< "rep r = 0 for rows", the outermost first
    WireEnd from, to;
};

/// Where a wire to the host leads to.
struct HostWires {
    std::string loop; ///< "" for one wire
    std::string sun;  ///< the link of the workstation, "0"
    std::string at;   ///< the subscripts of the processor
    std::string link; ///< an expression, "dimensions"
};

/// A topology of its size, in pieces of the netlist language: all that it says of the array t of processors. Pieces
/// follow from the vals, so that `--set` makes another size of the same netlist.
struct Topology {
    std::string about;             ///< "A ring of 8 processors"
    std::vector<std::string> vals; ///< "val rows 4;", among them one called nodes: the number of processors
    std::string array;             ///< the subscripts with which t is declared, "[rows][columns]"
    std::string first;             ///< those of processor number 0, "[0][0]"
    std::string at;                ///< those of processor number i, "[i / columns][i % columns]"
    std::vector<Wires> wires;
    HostWires host;
    std::string no_host = ""; ///< why no link is left for a wire to the host; "" if one is
};

std::vector<std::string> names_of_topologies();

/// Throws UserError where there is no such topology, it has no such size, or a processor of it would need more links
/// than a transputer has.
Topology topology_of(const Wish&);

} // namespace placedpar::generate
