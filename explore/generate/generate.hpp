#pragma once

#include "explore/generate/distances.hpp"
#include "explore/generate/topology_request.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <string>

namespace placedpar {
class RecordedProblem; // gaprocs/problem_registry.hpp
}

namespace placedpar::generate {

/// A generated netlist, which has been read and checked.
struct Generated {
    std::string text;
    Distances distances;
};

/// Makes the netlist of a machine, such as a ring of 8 transputers, and of its processes (the job). Throws UserError if
/// the topology or job is unknown, if the topology cannot have this size, or if a processor would need more links than
/// a transputer has. `problem` is the problem that TopologyRequest::problem names; null if this name is "".
Generated generate(const TopologyRequest&, const Catalogue&, const RecordedProblem* problem = nullptr);

} // namespace placedpar::generate
