#pragma once

#include "explore/generate/topology.hpp"

#include <string>

namespace placedpar::generate {

/// What runs on the processors t of a topology, and where: the rest of a netlist.
struct Job {
    bool has_host = false;  ///< a process `host`, which the netlist has to place
    std::string about;      ///< "islands of algorithm B, each with its neighbours' as its neighbours"
    std::string vals;       ///< lines, each with its end
    std::string statements; ///< likewise
};

/// A master, and a slave on every other processor; what is not a neighbour of the master is led through others.
Job farm(const Topology&);
/// An island on every processor; what is wired exchanges individuals.
Job islands(const Topology&);
/// Places an island on the head of each chain of figure-e2, and its slaves along the chain.
Job islands_with_slaves();
/// A process of that kind on every processor, connected with its neighbours by these ports, which are arrays.
Job processes_of(const std::string& kind, bool has_host, const std::string& output, const std::string& input,
                 const Topology&);

} // namespace placedpar::generate
